#include "LosTopos/mesh/audit_links.h"

#include <algorithm>

#include "LosTopos/mesh/audit_findings.h"

namespace lostopos {
namespace {

// Adds one for each place where `element` is in `corners`; how many there are.
template <class H, std::size_t n>
int count_in(const std::array<H, n>& corners, H element, std::array<std::uint8_t, n>& listed) {
  int places = 0;
  for (std::size_t i = 0; i < n; ++i) {
    if (corners[i] != element) continue;
    ++places;
    if (listed[i] < 2) ++listed[i];
  }
  return places;
}

class LinkAudit {
 public:
  LinkAudit(const SurfaceMesh& mesh, std::size_t most)
      : mesh_(mesh),
        findings_(report_, most),
        at_corners_(mesh.triangle_slots()),
        at_sides_(mesh.triangle_slots()),
        at_ends_(mesh.edge_slots()) {}

  AuditReport run() {
    check_vertices();
    check_edges();
    check_triangles();
    check_ends();
    check_double_edges();
    // Behind the links: a list of findings that is full of these must not hide one of those.
    check_positions();
    check_labels();
    return std::move(report_);
  }

 private:
  // First, what vertices and edges list, counting how often triangles and edges are; then, that these are listed once.
  void check_vertices() {
    for (Vertex v : mesh_.vertices()) {
      for (Triangle t : mesh_.triangles(v))
        if (!mesh_.alive(t) || count_in(mesh_.vertices(t), v, at_corners_[t.index()]) != 1)
          findings_.add(Defect::broken_incidence, described(mesh_, v), " lists triangle ", t.index(),
                        ", which does not have it as a corner");
      for (Edge e : mesh_.edges(v))
        if (!mesh_.alive(e) || count_in(mesh_.vertices(e), v, at_ends_[e.index()]) != 1)
          findings_.add(Defect::broken_incidence, described(mesh_, v), " lists edge ", e.index(),
                        ", which does not end there");
    }
  }

  void check_edges() {
    for (Edge e : mesh_.edges()) {
      if (mesh_.triangles(e).empty()) findings_.add(Defect::broken_incidence, "edge ", e.index(), " has no triangle");
      for (Triangle t : mesh_.triangles(e))
        if (!mesh_.alive(t) || count_in(mesh_.edges(t), e, at_sides_[t.index()]) != 1)
          findings_.add(Defect::broken_incidence, "edge ", e.index(), " lists triangle ", t.index(),
                        ", which does not have it");
    }
  }

  void check_triangles() {
    for (Triangle t : mesh_.triangles())
      for (std::size_t i = 0; i < 3; ++i) check_corner(t, i);
  }

  void check_corner(Triangle t, std::size_t i) {
    const Vertex v = mesh_.vertices(t)[i];
    const Edge e = mesh_.edges(t)[i];
    if (!mesh_.alive(v) || at_corners_[t.index()][i] != 1) {
      findings_.add(Defect::broken_incidence, "triangle ", t.index(), " is not listed once at its vertex ", v.index());
      return;
    }
    if (!mesh_.alive(e) || !joins(e, mesh_.vertices(t)[(i + 1) % 3], mesh_.vertices(t)[(i + 2) % 3]) ||
        at_sides_[t.index()][i] != 1)
      findings_.add(Defect::broken_incidence, "triangle ", t.index(), " and its edge ", e.index(),
                    " contradict each other");
  }

  bool joins(Edge e, Vertex a, Vertex b) const {
    const auto& ends = mesh_.vertices(e);
    return a != b && ((ends[0] == a && ends[1] == b) || (ends[0] == b && ends[1] == a));
  }

  void check_ends() {
    for (Edge e : mesh_.edges()) {
      const auto [a, b] = mesh_.vertices(e);
      const auto& listed = at_ends_[e.index()];
      if (a == b || !mesh_.alive(a) || !mesh_.alive(b) || listed[0] != 1 || listed[1] != 1)
        findings_.add(Defect::broken_incidence, "edge ", e.index(), " is not listed once at both of its ends");
    }
  }

  void check_double_edges() {
    std::vector<std::array<std::uint32_t, 3>> all;  // both ends in order, and the edge
    all.reserve(mesh_.edge_count());
    for (Edge e : mesh_.edges()) {
      const auto [a, b] = mesh_.vertices(e);
      all.push_back({std::min(a, b).index(), std::max(a, b).index(), e.index()});
    }
    std::ranges::sort(all);
    for (std::size_t i = 1; i < all.size(); ++i)
      if (all[i][0] == all[i - 1][0] && all[i][1] == all[i - 1][1])
        findings_.add(Defect::broken_incidence, "edges ", all[i][2], " and ", all[i - 1][2], " join the same vertices ",
                      all[i][0], " and ", all[i][1]);
  }

  void check_positions() {
    for (Vertex v : mesh_.vertices())
      if (!mesh_.position(v).allFinite())
        findings_.add(Defect::not_finite, described(mesh_, v), " has a coordinate that is not finite");
  }

  void check_labels() {
    for (Triangle t : mesh_.triangles()) {
      const Labels labels = mesh_.labels(t);
      if (!labels.p.valid() || !labels.q.valid() || labels.p == labels.q)
        findings_.add(Defect::bad_labels, "triangle ", t.index(), " has labels (", labels.p.index(), ", ",
                      labels.q.index(), ")");
    }
    for (Vertex v : mesh_.vertices())
      if (mesh_.triangles(v).empty()) findings_.add(Defect::isolated_vertex, described(mesh_, v), " has no triangle");
  }

  const SurfaceMesh& mesh_;
  AuditReport report_;
  AuditFindings findings_;
  // How often, up to twice, each corner, side and end is listed where it is.
  std::vector<std::array<std::uint8_t, 3>> at_corners_, at_sides_;
  std::vector<std::array<std::uint8_t, 2>> at_ends_;
};

}  // namespace

std::string described(const SurfaceMesh& mesh, Vertex v) {
  std::ostringstream text;
  text.precision(17);
  text << "vertex " << v.index() << " at (" << mesh.position(v).transpose() << ")";
  return text.str();
}

AuditReport audit_links(const SurfaceMesh& mesh, std::size_t max_findings) {
  return LinkAudit(mesh, max_findings).run();
}

}  // namespace lostopos
