// Random sequences of changes, against a model that keeps nothing but a list of triangles.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <map>
#include <set>

#include "LosTopos/error.h"
#include "LosTopos/mesh/audit.h"
#include "LosTopos/mesh/surface_mesh.h"

namespace lostopos {
namespace {

// Vertices and triangles have names that never change; the mesh knows them only as attributes.
struct Model {
  struct Face {
    std::array<int, 3> corners;
    Labels labels;
  };
  std::map<int, Vec3> vertices;
  std::map<int, Face> faces;
  int next_name = 0;
};

class Subject {
 public:
  Subject() : vertex_name_(mesh_.add_vertex_attribute<int>(-1)), face_name_(mesh_.add_triangle_attribute<int>(-1)) {}

  void add_vertex(int x, int y, int z) {
    const Vec3 position(x, y, z);
    const Vertex v = mesh_.add_vertex(position);
    RC_ASSERT(vertex_name_[v] == -1);
    vertex_name_[v] = model_.next_name;
    model_.vertices[model_.next_name++] = position;
  }

  void add_triangle(unsigned a, unsigned b, unsigned c, unsigned p, unsigned q) {
    const int i = pick(model_.vertices, a), j = pick(model_.vertices, b), k = pick(model_.vertices, c);
    const Labels labels{Region(p % 4), Region(q % 4)};
    if (i < 0 || i == j || j == k || k == i || labels.p == labels.q) return;
    const Triangle t = mesh_.add_triangle(vertex(i), vertex(j), vertex(k), labels);
    RC_ASSERT(face_name_[t] == -1);
    face_name_[t] = model_.next_name;
    model_.faces[model_.next_name++] = {{i, j, k}, labels};
  }

  void remove_triangle(unsigned which) {
    const int name = pick(model_.faces, which);
    if (name < 0) return;
    mesh_.remove_triangle(face(name));
    model_.faces.erase(name);
  }

  void remove_vertex(unsigned which) {
    const int name = pick(model_.vertices, which);
    if (name < 0) return;
    const bool used = std::ranges::any_of(
        model_.faces, [name](const auto& f) { return std::ranges::count(f.second.corners, name) > 0; });
    if (used) {
      RC_ASSERT_THROWS_AS(mesh_.remove_vertex(vertex(name)), MeshError);
      return;
    }
    mesh_.remove_vertex(vertex(name));
    model_.vertices.erase(name);
  }

  void compact() {
    mesh_.compact();
    RC_ASSERT(mesh_.vertex_slots() == model_.vertices.size());
    RC_ASSERT(mesh_.triangle_slots() == model_.faces.size());
  }

  void check() const {
    RC_ASSERT(mesh_.vertex_count() == model_.vertices.size());
    RC_ASSERT(mesh_.triangle_count() == model_.faces.size());
    check_faces();
    check_edges();
    const AuditReport report = audit(mesh_, {.intersections = false, .closed_regions = false, .max_findings = 1000});
    RC_ASSERT(!report.has(Defect::broken_incidence));
    RC_ASSERT(!report.has(Defect::bad_labels));
  }

 private:
  template <class Map>
  static int pick(const Map& map, unsigned which) {
    return map.empty() ? -1 : std::next(map.begin(), static_cast<long>(which % map.size()))->first;
  }

  Vertex vertex(int name) const {
    for (Vertex v : mesh_.vertices())
      if (vertex_name_[v] == name) return v;
    return {};
  }

  Triangle face(int name) const {
    for (Triangle t : mesh_.triangles())
      if (face_name_[t] == name) return t;
    return {};
  }

  void check_faces() const {
    std::map<int, std::multiset<int>> faces_at;
    for (const auto& [name, face] : model_.faces)
      for (int corner : face.corners) faces_at[corner].insert(name);
    for (Triangle t : mesh_.triangles()) {
      const Model::Face& expected = model_.faces.at(face_name_[t]);
      for (std::size_t i = 0; i < 3; ++i) RC_ASSERT(vertex_name_[mesh_.vertices(t)[i]] == expected.corners[i]);
      RC_ASSERT(mesh_.labels(t) == expected.labels);
    }
    for (Vertex v : mesh_.vertices()) {
      RC_ASSERT(mesh_.position(v) == model_.vertices.at(vertex_name_[v]));
      std::multiset<int> found;
      for (Triangle t : mesh_.triangles(v)) found.insert(face_name_[t]);
      RC_ASSERT(found == faces_at[vertex_name_[v]]);
    }
  }

  void check_edges() const {
    std::map<std::pair<int, int>, std::multiset<int>> expected;
    for (const auto& [name, face] : model_.faces)
      for (std::size_t i = 0; i < 3; ++i)
        expected[std::minmax(face.corners[i], face.corners[(i + 1) % 3])].insert(name);
    RC_ASSERT(mesh_.edge_count() == expected.size());
    for (Edge e : mesh_.edges()) {
      const int a = vertex_name_[mesh_.vertices(e)[0]], b = vertex_name_[mesh_.vertices(e)[1]];
      std::multiset<int> found;
      for (Triangle t : mesh_.triangles(e)) found.insert(face_name_[t]);
      RC_ASSERT(found == expected.at(std::minmax(a, b)));
      RC_ASSERT(mesh_.find_edge(mesh_.vertices(e)[1], mesh_.vertices(e)[0]) == e);
      RC_ASSERT(mesh_.is_junction(e) == (found.size() > 2));
    }
  }

  SurfaceMesh mesh_;
  Model model_;
  VertexAttribute<int> vertex_name_;
  TriangleAttribute<int> face_name_;
};

RC_GTEST_PROP(MeshSequence, BehavesLikeAListOfTriangles, ()) {
  Subject subject;
  const auto codes = *rc::gen::container<std::vector<std::array<unsigned, 6>>>(
      rc::gen::container<std::array<unsigned, 6>>(rc::gen::inRange(0U, 1000U)));
  for (const auto& [op, a, b, c, p, q] : codes) {
    // Additions more often than removals, so that meshes grow.
    switch (op % 10) {
      case 0:
      case 1:
      case 2:
        subject.add_vertex(static_cast<int>(a), static_cast<int>(b), static_cast<int>(c));
        break;
      case 3:
      case 4:
      case 5:
      case 6:
        subject.add_triangle(a, b, c, p, q);
        break;
      case 7:
        subject.remove_triangle(a);
        break;
      case 8:
        subject.remove_vertex(a);
        break;
      default:
        subject.compact();
        break;
    }
    subject.check();
  }
}

}  // namespace
}  // namespace lostopos
