#include "FoamSim/scenes/shapes/octahedron_frame.h"

#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <random>
#include <vector>

#include "FoamSim/scenes/shapes/held.h"

namespace foamsim {

using lostopos::Labels;
using lostopos::Region;
using lostopos::SurfaceMesh;
using lostopos::Vec3;
using lostopos::Vertex;

namespace {

// The signs of the octant of region r + 1; those of regions 5 to 8 are those of their points.
const std::array<Vec3, 8>& octants() {
  static const std::array<Vec3, 8> signs{Vec3(-1, 1, 1), Vec3(1, -1, 1),  Vec3(1, 1, -1),  Vec3(-1, -1, -1),
                                         Vec3(1, 1, 1),  Vec3(-1, -1, 1), Vec3(-1, 1, -1), Vec3(1, -1, -1)};
  return signs;
}

class OctahedronBuilder {
 public:
  explicit OctahedronBuilder(std::uint64_t seed) {
    std::mt19937_64 random(seed);
    Vec3 centre;
    for (double& x : centre) x = 0.1 * (2 * std::ldexp(static_cast<double>(random() >> 11), -53) - 1);
    centre_ = mesh_.add_vertex(centre);
    for (int k = 0; k < 6; ++k) corners_.at(k) = mesh_.add_vertex((k < 3 ? 1 : -1) * Vec3::Unit(k % 3));
    for (int i = 0; i < 4; ++i) inner_.at(i) = mesh_.add_vertex(0.3 * octants().at(4 + i));
  }

  SurfaceMesh build() {
    add_inner_films();
    std::vector<Vertex> held(corners_.begin(), corners_.end());
    for (std::size_t r = 0; r < 8; ++r) held.push_back(add_cap(r));
    mark_held(mesh_, held);
    return std::move(mesh_);
  }

 private:
  Vertex corner(int axis, double sign) const {
    return corners_.at(static_cast<std::size_t>(sign > 0 ? axis : axis + 3));
  }

  // Between the regions of two octants.
  void add(Vertex a, Vertex b, Vertex c, std::size_t r, std::size_t s) {
    const Vec3 x = mesh_.position(a);
    const Vec3 normal = (mesh_.position(b) - x).cross(mesh_.position(c) - x);
    const Labels labels{Region(r + 1), Region(s + 1)};
    mesh_.add_triangle(a, b, c, normal.dot(octants().at(s) - octants().at(r)) > 0 ? labels : labels.flipped());
  }

  void add_inner_films() {
    for (std::size_t i = 0; i < 4; ++i)
      for (std::size_t j = i + 1; j < 4; ++j) {
        // Points i and j share one sign, along the axis of the corner that their faces share; the octants beside are
        // those that differ from both in one sign.
        const Vec3 sum = octants().at(4 + i) + octants().at(4 + j);
        int axis = 0;
        sum.cwiseAbs().maxCoeff(&axis);
        std::array<std::size_t, 2> beside{};
        std::size_t found = 0;
        for (std::size_t r = 0; r < 4; ++r)
          if (octants().at(r)[axis] == octants().at(4 + i)[axis]) beside.at(found++) = r;
        add(centre_, inner_.at(i), inner_.at(j), beside[0], beside[1]);
        add(corner(axis, sum[axis]), inner_.at(i), inner_.at(j), beside[0], beside[1]);
      }
    for (std::size_t i = 0; i < 4; ++i)
      for (int across = 0; across < 3; ++across) add_side_film(i, across);
  }

  // From the edge of point i's face that lies across an axis.
  void add_side_film(std::size_t i, int across) {
    const Vec3& signs = octants().at(4 + i);
    Vec3 other = signs;
    other[across] *= -1;
    std::size_t neighbour = 0;
    while (octants().at(neighbour) != other) ++neighbour;
    const int u = (across + 1) % 3, v = (across + 2) % 3;
    add(corner(u, signs[u]), corner(v, signs[v]), inner_.at(i), 4 + i, neighbour);
  }

  // Closes region r + 1 towards the air; returns the tip.
  Vertex add_cap(std::size_t r) {
    const Vec3& signs = octants().at(r);
    const Vertex tip = mesh_.add_vertex(0.5 * signs);
    for (int across = 0; across < 3; ++across) {
      const int u = (across + 1) % 3, v = (across + 2) % 3;
      const Vertex a = corner(u, signs[u]), b = corner(v, signs[v]);
      const Vec3 normal = (mesh_.position(b) - mesh_.position(a)).cross(mesh_.position(tip) - mesh_.position(a));
      const Labels outwards{Region(r + 1), lostopos::air};
      mesh_.add_triangle(a, b, tip, normal.dot(signs) > 0 ? outwards : outwards.flipped());
    }
    return tip;
  }

  SurfaceMesh mesh_;
  Vertex centre_;
  std::array<Vertex, 6> corners_;
  std::array<Vertex, 4> inner_;
};

}  // namespace

SurfaceMesh octahedron_frame(std::uint64_t seed) {
  return OctahedronBuilder(seed).build();
}

}  // namespace foamsim
