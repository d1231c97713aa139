#include "LosTopos/mesh/audit.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

#include "LosTopos/geometry/predicates.h"
#include "LosTopos/mesh/audit_findings.h"
#include "LosTopos/mesh/audit_intersections.h"
#include "LosTopos/mesh/audit_links.h"
#include "LosTopos/mesh/measures.h"
#include "LosTopos/mesh/region_lines.h"

namespace lostopos {
namespace {

class Auditor {
 public:
  Auditor(const SurfaceMesh& mesh, const AuditOptions& options)
      : mesh_(mesh),
        options_(options),
        report_(audit_links(mesh, options.max_findings)),
        findings_(report_, options.max_findings) {}

  AuditReport run() {
    // The geometric checks walk the incidence and compute with positions: both must be sound first.
    if (report_.has(Defect::broken_incidence) || report_.has(Defect::not_finite)) return std::move(report_);
    check_duplicates();
    for (Edge e : mesh_.edges()) check_regions_around(e);
    if (!options_.intersections) return std::move(report_);
    if (!findings_.full()) check_intersections();
    if (!ends_in_the_open_ && labels_make_sense()) check_insides();
    return std::move(report_);
  }

 private:
  void check_duplicates() {
    for (Edge e : mesh_.edges()) {
      const auto around = mesh_.triangles(e);
      for (std::size_t i = 0; i < around.size(); ++i)
        for (std::size_t j = i + 1; j < around.size(); ++j) {
          const bool same = mesh_.opposite_vertex(around[i], e) == mesh_.opposite_vertex(around[j], e);
          if (same && *std::ranges::min_element(mesh_.edges(around[i])) == e)
            findings_.add(Defect::duplicate_triangle, "triangles ", around[i].index(), " and ", around[j].index(),
                          " have the same three vertices");
        }
    }
    for (Triangle t : mesh_.triangles()) {
      const auto [a, b, c] = corners(mesh_, t);
      if (collinear(a, b, c))
        findings_.add(Defect::degenerate_triangle, "triangle ", t.index(), " has its corners on a line");
    }
  }

  // The regions met on a turn about the edge: each film's far region has to be the next film's near region.
  void check_regions_around(Edge e) {
    const auto around = mesh_.triangles(e);
    const auto [a, b] = mesh_.vertices(e);
    const Vec3 outward =
        options_.walls ? outward_of_shared_walls(*options_.walls, mesh_.position(a), mesh_.position(b)) : Vec3::Zero();
    if (around.size() == 1) {
      const bool at_wall = !outward.isZero(0);
      (at_wall ? ends_at_walls_ : ends_in_the_open_) = true;
      if (options_.closed_regions && !at_wall)
        findings_.add(Defect::open_region, "the surface ends at edge ", e.index(), " (", described(mesh_, a), ", ",
                      described(mesh_, b), ")");
      return;
    }
    const Vec3 axis = mesh_.position(b) - mesh_.position(a);
    const Vec3 u = axis.unitOrthogonal(), w = axis.normalized().cross(u);
    struct Film {
      double angle;
      Region before, after;
    };
    std::vector<Film> films;
    for (Triangle t : around) {
      const Vec3 arm = mesh_.position(mesh_.opposite_vertex(t, e)) - mesh_.position(a);
      const Labels labels = mesh_.runs_along(t, e) ? mesh_.labels(t) : mesh_.labels(t).flipped();
      films.push_back({std::atan2(arm.dot(w), arm.dot(u)), labels.p, labels.q});
    }
    std::ranges::sort(films, {}, &Film::angle);
    // Nothing is known of what lies beyond a wall.
    const double beyond =
        outward.isZero(0) ? std::numeric_limits<double>::quiet_NaN() : std::atan2(outward.dot(w), outward.dot(u));
    for (std::size_t i = 0; i < films.size(); ++i) {
      const Film& film = films[i];
      const Film& next = films[(i + 1) % films.size()];
      if (film.after != next.before && !nearly_same_direction(films, i) && !lies_between(films, i, beyond))
        findings_.add(Defect::inconsistent_labels, "around edge ", e.index(), " (", described(mesh_, a), ", ",
                      described(mesh_, b), ") region ", film.after.index(), " meets region ", next.before.index(),
                      " with no film between them");
    }
  }

  // Whether a direction lies between film i and the next; one that is not a number does not.
  template <class Films>
  static bool lies_between(const Films& films, std::size_t i, double direction) {
    const double from = films[i].angle, to = films[(i + 1) % films.size()].angle;
    return from < to ? from < direction && direction < to : direction > from || direction < to;
  }

  // Films whose directions rounding cannot tell apart may be sorted either way; the intersection test judges them.
  template <class Films>
  static bool nearly_same_direction(const Films& films, std::size_t i) {
    constexpr double resolution = 1e-9;
    const std::size_t n = films.size();
    auto gap = [&](std::size_t k) { return std::abs(films[(k + 1) % n].angle - films[k % n].angle); };
    return gap(i + n - 1) < resolution || gap(i) < resolution || gap(i + 1) < resolution;
  }

  bool labels_make_sense() const {
    return std::ranges::none_of(
        std::array{Defect::bad_labels, Defect::duplicate_triangle, Defect::inconsistent_labels, Defect::intersection},
        [this](Defect defect) { return report_.has(defect); });
  }

  // What the edges cannot tell: they agree on a bubble that is turned inside out.
  void check_insides() {
    for (const std::string& message : contradictions_on_lines(mesh_, !ends_at_walls_, options_.max_findings))
      findings_.add(Defect::inside_out, message);
  }

  void check_intersections() {
    for (const EdgeTriangleContact& contact : edge_triangle_contacts(mesh_, options_.max_findings))
      findings_.add(Defect::intersection, "edge ", contact.edge.index(), " meets triangle ", contact.triangle.index(),
                    " near ", described(mesh_, mesh_.vertices(contact.edge)[0]));
    for (Edge e : mesh_.edges()) check_folds(e);
  }

  void check_folds(Edge e) {
    const auto around = mesh_.triangles(e);
    const auto [a, b] = mesh_.vertices(e);
    for (std::size_t i = 0; i < around.size(); ++i)
      for (std::size_t j = i + 1; j < around.size(); ++j)
        if (coplanar_overlap_sharing_edge(mesh_.position(a), mesh_.position(b),
                                          mesh_.position(mesh_.opposite_vertex(around[i], e)),
                                          mesh_.position(mesh_.opposite_vertex(around[j], e))))
          findings_.add(Defect::intersection, "triangles ", around[i].index(), " and ", around[j].index(),
                        " are folded onto each other at edge ", e.index());
  }

  const SurfaceMesh& mesh_;
  const AuditOptions& options_;
  AuditReport report_;
  AuditFindings findings_;
  bool ends_at_walls_ = false, ends_in_the_open_ = false;
};

}  // namespace

const char* name(Defect defect) {
  switch (defect) {
    case Defect::broken_incidence:
      return "broken incidence";
    case Defect::bad_labels:
      return "bad labels";
    case Defect::duplicate_triangle:
      return "duplicate triangle";
    case Defect::isolated_vertex:
      return "isolated vertex";
    case Defect::not_finite:
      return "not finite";
    case Defect::degenerate_triangle:
      return "degenerate triangle";
    case Defect::open_region:
      return "open region";
    case Defect::inconsistent_labels:
      return "inconsistent labels";
    case Defect::inside_out:
      return "inside out";
    case Defect::intersection:
      return "intersection";
  }
  return "unknown defect";
}

bool AuditReport::has(Defect defect) const {
  return std::ranges::any_of(findings, [defect](const Finding& f) { return f.defect == defect; });
}

std::string AuditReport::text() const {
  if (clean()) return "clean";
  std::string text;
  for (const Finding& finding : findings) text += std::string(name(finding.defect)) + ": " + finding.message + "\n";
  if (truncated) text += "(more findings left out)\n";
  return text;
}

AuditReport audit(const SurfaceMesh& mesh, const AuditOptions& options) {
  return Auditor(mesh, options).run();
}

}  // namespace lostopos
