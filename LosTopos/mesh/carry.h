#pragma once

#include <algorithm>
#include <concepts>
#include <memory>
#include <type_traits>
#include <utility>
#include <vector>

#include "LosTopos/mesh/carry_policy.h"
#include "LosTopos/mesh/patch.h"

/// How a named attribute's values follow the operations: `carry::interpolate`, `carry::copy`, `carry::conserve`, or
/// std::make_unique of a CarryPolicy of one's own.
namespace lostopos::carry {

/// Vertices: the mean of the two ends on a split edge; (1 − t) and t parts of two vertices, or places, that become one;
/// both copies of a vertex that parts have its value.
struct Interpolate {};
inline constexpr Interpolate interpolate;

/// For what cannot be mixed. Vertices: the value of the first end of a split edge, of the nearer of two places that
/// become one (of its heaviest vertex), of the vertex that parts. Triangles: the parent's. Edges: both halves of a
/// split edge and the edge that replaces a turned one have its value, edges that go from a vertex to another with it
/// keep theirs; those that are new within a triangle have the initial one.
struct Copy {};
inline constexpr Copy copy;

/// Vertices: as `interpolate`, and then the values around are changed together so that the integral over the surface,
/// Σ value × vertex area (a third of each triangle), is to rounding what it was before the operation: by a factor where
/// they have one sign, so that they keep it, else by a sum. For densities over area, such as a film's thickness. Motion
/// between operations changes areas, not values.
struct Conserve {};
inline constexpr Conserve conserve;

template <class T>
concept Mixable = requires(const T& a, double t) {
  T((1 - t) * a + t * a);
}
&&!std::integral<T>;

template <Mixable T>
T zero() {
  if constexpr (std::is_arithmetic_v<T>)
    return T{0};
  else
    return T::Zero();
}

template <Mixable T>
class InterpolatePolicy : public CarryPolicy<Vertex, T> {
 public:
  void after_split(const SurfaceMesh&, const SplitEvent& e) override {
    value(e.added) = 0.5 * (value(e.ends[0]) + value(e.ends[1]));
  }
  void after_collapse(const SurfaceMesh&, const CollapseEvent& e) override {
    value(e.kept) = (1 - e.t) * value(e.kept) + e.t * value(e.removed);
  }
  void after_merge(const SurfaceMesh&, const MergeEvent& e) override {
    const T mixed = (1 - e.t) * at(e.places[0]) + e.t * at(e.places[1]);
    value(e.result) = mixed;
  }
  void after_separation(const SurfaceMesh&, const SeparationEvent& e) override { value(e.added) = value(e.vertex); }

 protected:
  using CarryPolicy<Vertex, T>::value;

 private:
  T at(const Place& place) const {
    T mean = zero<T>();
    for (std::size_t i = 0; i < place.count; ++i) mean += place.weights[i] * value(place.vertices[i]);
    return mean;
  }
};

template <class T>
class CopyToVertices final : public CarryPolicy<Vertex, T> {
 public:
  void after_split(const SurfaceMesh&, const SplitEvent& e) override { value(e.added) = value(e.ends[0]); }
  void after_collapse(const SurfaceMesh&, const CollapseEvent& e) override {
    if (e.t > 0.5) value(e.kept) = value(e.removed);
  }
  void after_merge(const SurfaceMesh&, const MergeEvent& e) override {
    const T nearer = value(heaviest_vertex(e.places[e.t > 0.5 ? 1 : 0]));
    value(e.result) = nearer;
  }
  void after_separation(const SurfaceMesh&, const SeparationEvent& e) override { value(e.added) = value(e.vertex); }

 private:
  using CarryPolicy<Vertex, T>::value;
};

template <class T>
class CopyToTriangles final : public CarryPolicy<Triangle, T> {
 public:
  void after_split(const SurfaceMesh&, const SplitEvent& e) override { hand_on(e.triangles); }
  void after_collapse(const SurfaceMesh&, const CollapseEvent& e) override { hand_on(e.triangles); }
  void after_flip(const SurfaceMesh&, const FlipEvent& e) override { hand_on(e.triangles); }
  void after_merge(const SurfaceMesh&, const MergeEvent& e) override { hand_on(e.triangles); }
  void after_separation(const SurfaceMesh&, const SeparationEvent& e) override { hand_on(e.triangles); }

 private:
  void hand_on(std::span<const TriangleSource> sources) {
    for (const auto& [child, parent] : sources) this->value(child) = this->value(parent);
  }
};

template <class T>
class CopyToEdges final : public CarryPolicy<Edge, T> {
 public:
  void before_split(const SurfaceMesh& mesh, const SplitEvent& e) override { origins_.before(mesh, e); }
  void after_split(const SurfaceMesh& mesh, const SplitEvent& e) override { hand_on(origins_.after(mesh, e)); }
  void before_collapse(const SurfaceMesh& mesh, const CollapseEvent& e) override { origins_.before(mesh, e); }
  void after_collapse(const SurfaceMesh& mesh, const CollapseEvent& e) override { hand_on(origins_.after(mesh, e)); }
  void after_flip(const SurfaceMesh&, const FlipEvent& e) override { this->value(e.added) = this->value(e.edge); }
  void before_merge(const SurfaceMesh& mesh, const MergeEvent& e) override { origins_.before(mesh, e); }
  void after_merge(const SurfaceMesh& mesh, const MergeEvent& e) override { hand_on(origins_.after(mesh, e)); }
  void before_separation(const SurfaceMesh& mesh, const SeparationEvent& e) override { origins_.before(mesh, e); }
  void after_separation(const SurfaceMesh& mesh, const SeparationEvent& e) override {
    hand_on(origins_.after(mesh, e));
  }

 private:
  void hand_on(std::span<const EdgeSource> sources) {
    for (const auto& [child, parent] : sources) this->value(child) = this->value(parent);
  }
  EdgeOrigins origins_;
};

template <Mixable T>
class ConservePolicy final : public InterpolatePolicy<T> {
 public:
  void before_split(const SurfaceMesh& mesh, const SplitEvent& e) override { begin(mesh, patch_of(mesh, e)); }
  void after_split(const SurfaceMesh& mesh, const SplitEvent& e) override {
    InterpolatePolicy<T>::after_split(mesh, e);
    end(mesh, e.added);
  }
  void before_collapse(const SurfaceMesh& mesh, const CollapseEvent& e) override { begin(mesh, patch_of(mesh, e)); }
  void after_collapse(const SurfaceMesh& mesh, const CollapseEvent& e) override {
    InterpolatePolicy<T>::after_collapse(mesh, e);
    end(mesh, {});
  }
  void before_flip(const SurfaceMesh& mesh, const FlipEvent& e) override { begin(mesh, patch_of(mesh, e)); }
  void after_flip(const SurfaceMesh& mesh, const FlipEvent&) override { end(mesh, {}); }
  void before_move(const SurfaceMesh& mesh, const MoveEvent& e) override { begin(mesh, patch_of(mesh, e)); }
  void after_move(const SurfaceMesh& mesh, const MoveEvent&) override { end(mesh, {}); }
  void before_merge(const SurfaceMesh& mesh, const MergeEvent& e) override { begin(mesh, patch_of(mesh, e)); }
  void after_merge(const SurfaceMesh& mesh, const MergeEvent& e) override {
    InterpolatePolicy<T>::after_merge(mesh, e);
    end(mesh, e.result);
  }
  void before_separation(const SurfaceMesh& mesh, const SeparationEvent& e) override { begin(mesh, patch_of(mesh, e)); }
  void after_separation(const SurfaceMesh& mesh, const SeparationEvent& e) override {
    InterpolatePolicy<T>::after_separation(mesh, e);
    end(mesh, e.added);
  }

 private:
  struct Integral {
    T sum = zero<T>();
    double area = 0;
  };

  Integral integral(const SurfaceMesh& mesh) const {
    Integral over;
    for (Vertex v : patch_) {
      const double area = vertex_area(mesh, v);
      over.sum += area * this->value(v);
      over.area += area;
    }
    return over;
  }
  void begin(const SurfaceMesh& mesh, std::vector<Vertex> patch) {
    patch_ = std::move(patch);
    if (!patch_.empty()) before_ = integral(mesh).sum;
  }
  // `joined`: a vertex that the operation has added to the patch, if any.
  void end(const SurfaceMesh& mesh, Vertex joined) {
    if (patch_.empty()) return;
    keep_living(mesh, patch_, joined);
    if (patch_.empty()) return;
    const Integral now = integral(mesh);
    if (!(now.area > 0)) return;
    if constexpr (std::floating_point<T>) {
      const bool one_sign = std::ranges::all_of(patch_, [this](Vertex v) { return this->value(v) >= 0; }) ||
                            std::ranges::all_of(patch_, [this](Vertex v) { return this->value(v) <= 0; });
      const T factor = before_ / now.sum;
      if (one_sign && factor > 0 && factor < most) {
        for (Vertex v : patch_) this->value(v) *= factor;
        return;
      }
    }
    const T lacking = (1 / now.area) * (before_ - now.sum);
    for (Vertex v : patch_) this->value(v) += lacking;
  }

  // A larger factor means that hardly anything is left to be changed by one.
  static constexpr double most = 1e3;
  std::vector<Vertex> patch_;
  T before_ = zero<T>();
};

template <class H, class T>
std::unique_ptr<CarryPolicy<H, T>> make_policy(Interpolate) {
  static_assert(std::is_same_v<H, Vertex>, "only values of vertices can be interpolated");
  return std::make_unique<InterpolatePolicy<T>>();
}
template <class H, class T>
std::unique_ptr<CarryPolicy<H, T>> make_policy(Conserve) {
  static_assert(std::is_same_v<H, Vertex>, "only values of vertices have an integral that is kept");
  return std::make_unique<ConservePolicy<T>>();
}
template <class H, class T>
std::unique_ptr<CarryPolicy<H, T>> make_policy(Copy) {
  if constexpr (std::is_same_v<H, Vertex>)
    return std::make_unique<CopyToVertices<T>>();
  else if constexpr (std::is_same_v<H, Edge>)
    return std::make_unique<CopyToEdges<T>>();
  else
    return std::make_unique<CopyToTriangles<T>>();
}
template <class H, class T, class Own>
std::unique_ptr<CarryPolicy<H, T>> make_policy(std::unique_ptr<Own> own) {
  return own;
}

}  // namespace lostopos::carry
