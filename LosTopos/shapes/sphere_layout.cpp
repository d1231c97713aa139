#include "LosTopos/shapes/sphere_layout.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <string>

#include "Base/error.h"
#include "Base/names/nearest_name.h"
#include "LosTopos/shapes/solids.h"

namespace lostopos {
namespace {

constexpr double jitter = 0.08, smallest_in_grid = 0.34, largest_in_grid = 0.40;
constexpr double smallest_random = 0.15, largest_random = 0.45, least_gap = 0.02;
constexpr long subdivisions = 2;  // 320 triangles

// Numbers between two bounds, the same on every platform.
class Uniform {
 public:
  explicit Uniform(std::uint64_t seed) : random_(seed) {}
  double operator()(double low, double high) {
    const double unit = std::ldexp(static_cast<double>(random_() >> 11) + 0.5, -53);
    return low + (high - low) * unit;
  }
  Vec3 point(double low, double high) {
    Vec3 x;
    for (double& coordinate : x) coordinate = (*this)(low, high);
    return x;
  }

 private:
  std::mt19937_64 random_;
};

std::vector<Sphere> grid(long count, Uniform& uniform) {
  long side = 1;
  while (side * side * side < count) ++side;
  std::vector<Sphere> spheres;
  for (long i = 0; i < count; ++i) {
    const long row = i / side % side, layer = i / (side * side);
    const Vec3 node(static_cast<double>(i % side), static_cast<double>(row), static_cast<double>(layer));
    const Vec3 centre = node + uniform.point(-jitter, jitter);
    spheres.push_back({centre, uniform(smallest_in_grid, largest_in_grid)});
  }
  return spheres;
}

// The spheres placed so far, in cubes so large that only neighbouring ones can have spheres that touch.
class PlacedSpheres {
 public:
  explicit PlacedSpheres(long count) : buckets_(static_cast<std::size_t>(count)) {}

  bool has_room(const Sphere& sphere) const {
    const std::array<long, 3> home = cube_of(sphere.centre);
    for (long x = -1; x <= 1; ++x)
      for (long y = -1; y <= 1; ++y)
        for (long z = -1; z <= 1; ++z)
          if (touches_any(sphere, buckets_[bucket_of({home[0] + x, home[1] + y, home[2] + z})])) return false;
    return true;
  }
  void add(const Sphere& sphere) { buckets_[bucket_of(cube_of(sphere.centre))].push_back(sphere); }

 private:
  static bool touches_any(const Sphere& sphere, const std::vector<Sphere>& others) {
    return std::ranges::any_of(others, [&](const Sphere& other) {
      return (other.centre - sphere.centre).norm() < other.radius + sphere.radius + least_gap;
    });
  }
  static std::array<long, 3> cube_of(const Vec3& x) {
    constexpr double size = 2 * largest_random + least_gap;
    return {std::lround(x.x() / size), std::lround(x.y() / size), std::lround(x.z() / size)};
  }
  std::size_t bucket_of(const std::array<long, 3>& cube) const {
    std::uint64_t hash = 0;
    for (long i : cube) hash = (hash ^ static_cast<std::uint64_t>(i)) * 0x9E3779B97F4A7C15u;
    return hash % buckets_.size();
  }

  std::vector<std::vector<Sphere>> buckets_;
};

std::vector<Sphere> anywhere(long count, Uniform& uniform) {
  constexpr int attempts = 200;
  constexpr double growth = 1.02;
  double side = std::cbrt(static_cast<double>(count));
  PlacedSpheres placed(count);
  std::vector<Sphere> spheres;
  while (spheres.size() < static_cast<std::size_t>(count)) {
    Sphere sphere{Vec3::Zero(), uniform(smallest_random, largest_random)};
    bool found = false;
    for (int attempt = 0; attempt < attempts && !found; ++attempt) {
      sphere.centre = uniform.point(0, side);
      found = placed.has_room(sphere);
    }
    if (found) {
      placed.add(sphere);
      spheres.push_back(sphere);
    } else {
      side *= growth;
    }
  }
  return spheres;
}

struct NamedLayout {
  std::string_view name;
  SphereLayout layout;
};

}  // namespace

SphereLayout sphere_layout_by_name(std::string_view name) {
  static constexpr std::array layouts{NamedLayout{"grid", SphereLayout::grid},
                                      NamedLayout{"random", SphereLayout::random}};
  return base::find_by_name(layouts, name, "layout").layout;
}

std::vector<Sphere> sphere_layout(const SphereLayoutOptions& options) {
  constexpr long most = 1'000'000;
  if (options.spheres < 1 || options.spheres > most)
    throw base::InputError("a layout of " + std::to_string(options.spheres) + " spheres; it needs 1 to " +
                           std::to_string(most));
  Uniform uniform(options.seed);
  return options.layout == SphereLayout::grid ? grid(options.spheres, uniform) : anywhere(options.spheres, uniform);
}

SurfaceMesh sphere_meshes(const std::vector<Sphere>& spheres, bool one_region) {
  const SurfaceMesh unit = icosphere(subdivisions);
  SurfaceMesh mesh;
  mesh.reserve(spheres.size() * unit.vertex_count(), spheres.size() * unit.triangle_count());
  for (std::size_t i = 0; i < spheres.size(); ++i) {
    const std::size_t first = mesh.vertex_slots();
    for (Vertex v : unit.vertices()) mesh.add_vertex(spheres[i].centre + spheres[i].radius * unit.position(v));
    const Region region(one_region ? 1 : i + 1);
    for (Triangle t : unit.triangles()) {
      const auto [a, b, c] = unit.vertices(t);
      mesh.add_triangle(Vertex(first + a.index()), Vertex(first + b.index()), Vertex(first + c.index()), {region, air});
    }
  }
  return mesh;
}

}  // namespace lostopos
