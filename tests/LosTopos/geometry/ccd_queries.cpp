#include "tests/LosTopos/geometry/ccd_queries.h"

#include <Eigen/Geometry>
#include <cmath>

namespace lostopos::test {
namespace {

constexpr std::array<std::string_view, 12> family_names = {
    "on a grid", "coplanar", "near contact",    "grazing", "shared coordinates", "denormal",
    "collapsed", "scaled",   "far from origin", "fast",    "rigid neighbours",   "huge"};

Vec3 at(const Trajectory& p, double t) {
  return (1 - t) * p.start + t * p.end;
}

}  // namespace

std::optional<Collision> collide(Shape shape, const Query& q) {
  return shape == Shape::vertex_triangle ? vertex_triangle_collision(q[0], q[1], q[2], q[3])
                                         : edge_edge_collision(q[0], q[1], q[2], q[3]);
}

std::optional<ExactContact> exact_contact(Shape shape, const Query& q, const OracleOptions& options) {
  return shape == Shape::vertex_triangle ? exact_vertex_triangle(q, options) : exact_edge_edge(q, options);
}

double QueryGenerator::uniform(double low, double high) {
  return low + (high - low) * (static_cast<double>(bits_() >> 11) * 0x1p-53);
}

int QueryGenerator::integer(int low, int high) {
  return low + static_cast<int>(bits_() % static_cast<std::uint64_t>(high - low + 1));
}

double QueryGenerator::tiny() {
  const int k = integer(0, 20);
  return k == 0 ? 0 : std::pow(10.0, -k);
}

Vec3 QueryGenerator::point_in_cube() {
  const double x = uniform(0, 1);
  const double y = uniform(0, 1);
  return {x, y, uniform(0, 1)};
}

Query QueryGenerator::random() {
  Query q;
  for (Trajectory& p : q) {
    p.start = point_in_cube();
    p.end = p.start + 2 * point_in_cube() - Vec3::Ones();
  }
  return q;
}

std::string_view QueryGenerator::family() const {
  return family_names[(count_ - 1) % family_names.size()];
}

Query QueryGenerator::adversarial(Shape shape) {
  switch (count_++ % family_names.size()) {
    case 0:
      return on_a_grid();
    case 1:
      return coplanar();
    case 2:
      return near_contact(shape);
    case 3:
      return grazing(shape);
    case 4:
      return with_shared_coordinates();
    case 5:
      return of_size(shape, integer(-1073, -1030));
    case 6:
      return collapsed();
    case 7:
      return scaled(shape);
    case 8:
      return far_from_origin(shape);
    case 9:
      return fast(shape);
    case 10:
      return rigid_neighbours(shape);
    default:
      return of_size(shape, integer(1000, 1021));
  }
}

// Few values for many coordinates: everything degenerate happens often.
Query QueryGenerator::on_a_grid() {
  const int n = integer(1, 4);
  Query q;
  for (Trajectory& p : q) {
    for (int i = 0; i < 3; ++i) {
      p.start[i] = integer(0, n);
      p.end[i] = integer(0, n);
    }
  }
  return q;
}

void QueryGenerator::jitter(Query& q, double size) {
  for (Trajectory& p : q) {
    p.start += size * (2 * point_in_cube() - Vec3::Ones());
    p.end += size * (2 * point_in_cube() - Vec3::Ones());
  }
}

// In one plane, which may move or be oblique, up to a jitter.
Query QueryGenerator::coplanar() {
  Query q = random();
  for (Trajectory& p : q) p.start.z() = p.end.z() = 0.5;
  if (integer(0, 1) == 0) {
    for (Trajectory& p : q) p.end.z() = -1;
  }
  if (integer(0, 1) == 0) {
    for (Trajectory& p : q) {
      p.start.z() = p.start.x() + p.start.y();
      p.end.z() = p.end.x() + p.end.y();
    }
  }
  if (integer(0, 1) == 0) jitter(q, tiny());
  return q;
}

// Moves the first point so that the shapes meet, up to rounding, at the time given; in the interior or on the boundary.
void QueryGenerator::meet_at(Query& q, Shape shape, double time, bool tangentially) {
  double s = integer(0, 2) == 0 ? 0 : uniform(0, 1);
  double t = integer(0, 2) == 0 ? 0 : uniform(0, 1);
  if (shape == Shape::vertex_triangle && s + t > 1) {
    s = 1 - s;
    t = 1 - t;
  }
  const bool edges = shape == Shape::edge_edge;
  const Vec3 e1 = edges ? Vec3(at(q[1], time) - at(q[0], time)) : Vec3(at(q[2], time) - at(q[1], time));
  const Vec3 e2 = edges ? Vec3(at(q[3], time) - at(q[2], time)) : Vec3(at(q[3], time) - at(q[1], time));
  if (tangentially) {
    // A relative velocity in the plane of contact makes it a double root of the coplanarity cubic, or nearly.
    const Vec3 n = e1.cross(e2).normalized();
    const auto velocity = [&q](std::size_t i) { return Vec3(q[i].end - q[i].start); };
    const Vec3 relative = edges
                              ? Vec3((1 - s) * velocity(0) + s * velocity(1) - (1 - t) * velocity(2) - t * velocity(3))
                              : Vec3(velocity(0) - (1 - s - t) * velocity(1) - s * velocity(2) - t * velocity(3));
    const Vec3 excess = relative.dot(n) * n;
    q[0].end -= excess;
    if (edges) q[1].end -= excess;
  }
  const Vec3 gap = edges ? Vec3(at(q[2], time) + t * e2 - at(q[0], time) - s * (at(q[1], time) - at(q[0], time)))
                         : Vec3(at(q[1], time) + s * e1 + t * e2 - at(q[0], time));
  for (std::size_t i = 0; i < (edges ? 2U : 1U); ++i) {
    q[i].start += gap;
    q[i].end += gap;
  }
}

Query QueryGenerator::near_contact(Shape shape) {
  Query q = random();
  const int when = integer(0, 3);
  meet_at(q, shape, when == 0 ? 0 : when == 1 ? 1 : uniform(0, 1), false);
  jitter(q, tiny());
  return q;
}

Query QueryGenerator::grazing(Shape shape) {
  Query q = random();
  meet_at(q, shape, uniform(0, 1), true);
  jitter(q, tiny());
  return q;
}

Query QueryGenerator::with_shared_coordinates() {
  Query q = random();
  const int copies = integer(1, 16);
  for (int k = 0; k < copies; ++k) {
    Trajectory& to = q[static_cast<std::size_t>(integer(0, 3))];
    const Trajectory& from = q[static_cast<std::size_t>(integer(0, 3))];
    const int i = integer(0, 2);
    switch (integer(0, 3)) {
      case 0:
        to.start[i] = from.start[i];
        break;
      case 1:
        to.end[i] = from.end[i];
        break;
      case 2:
        to.end[i] = to.start[i];
        break;
      default:
        to.start[i] = from.end[i];
    }
  }
  return q;
}

// Edges of zero length, triangles on a line, points that rest or go the same way; at the start, the end or both.
Query QueryGenerator::collapsed() {
  Query q = random();
  const auto i = static_cast<std::size_t>(integer(0, 3));
  const auto j = static_cast<std::size_t>(integer(0, 3));
  const auto k = static_cast<std::size_t>(integer(0, 3));
  const double s = uniform(-0.5, 1.5);
  const int when = integer(0, 2);
  if (when != 0) q[i].start = s * q[j].start + (1 - s) * q[k].start;
  if (when != 1) q[i].end = s * q[j].end + (1 - s) * q[k].end;
  if (integer(0, 1) == 0) {
    for (Trajectory& p : q) p.start.x() = p.end.x() = 0;
  }
  if (integer(0, 1) == 0) jitter(q, tiny());
  return q;
}

// Near contact at 2^exponent: of denormals with few bits, or up to the overflow of differences.
Query QueryGenerator::of_size(Shape shape, int exponent) {
  Query q = near_contact(shape);
  for (Trajectory& p : q) {
    for (Vec3* x : {&p.start, &p.end}) {
      for (int i = 0; i < 3; ++i) (*x)[i] = std::ldexp((*x)[i], exponent);
    }
  }
  return q;
}

// From denormals to the overflow of differences, with axes that differ by up to 2^40.
Query QueryGenerator::scaled(Shape shape) {
  Query q = near_contact(shape);
  const int exponent = integer(-1060, 1021);
  const Vec3 stretch(std::ldexp(1.0, -integer(0, 40)), std::ldexp(1.0, -integer(0, 40)), 1);
  for (Trajectory& p : q) {
    for (Vec3* x : {&p.start, &p.end}) {
      *x = x->cwiseProduct(stretch);
      for (int i = 0; i < 3; ++i) (*x)[i] = std::ldexp((*x)[i], exponent);
    }
  }
  return q;
}

// A large offset, the same or not at the start and the end; coordinates round to a coarse grid, so contacts are common.
Query QueryGenerator::far_from_origin(Shape shape) {
  Query q = near_contact(shape);
  const double size = std::pow(10.0, integer(2, 16));
  const Vec3 start_offset = size * point_in_cube();
  const Vec3 end_offset = integer(0, 1) == 0 ? start_offset : Vec3(size * point_in_cube());
  for (Trajectory& p : q) {
    p.start += start_offset;
    p.end += end_offset;
  }
  return q;
}

// The first shape passes by at a speed of up to 10^12 sizes.
Query QueryGenerator::fast(Shape shape) {
  Query q = random();
  const double time = uniform(0, 1);
  const Vec3 velocity = std::pow(10.0, integer(1, 12)) * (2 * point_in_cube() - Vec3::Ones());
  for (std::size_t i = 0; i < (shape == Shape::edge_edge ? 2U : 1U); ++i) {
    q[i].start -= time * velocity;
    q[i].end += (1 - time) * velocity;
  }
  if (integer(0, 1) == 0) meet_at(q, shape, uniform(0, 1), false);
  jitter(q, tiny());
  return q;
}

// Both shapes turn together, the gap between them small against their size all the time: the tracker's daily bread.
Query QueryGenerator::rigid_neighbours(Shape shape) {
  Query q = random();
  for (Trajectory& p : q) p.end = p.start;
  meet_at(q, shape, 0, false);
  const Vec3 gap = tiny() * (2 * point_in_cube() - Vec3::Ones());
  for (std::size_t i = 0; i < (shape == Shape::edge_edge ? 2U : 1U); ++i) q[i].start += gap;
  const Vec3 axis = (2 * point_in_cube() - Vec3::Ones()).normalized();
  const Eigen::AngleAxisd turn(uniform(0, 0.5), axis);
  const Vec3 shift = point_in_cube();
  for (Trajectory& p : q) p.end = turn * p.start + shift;
  return q;
}

}  // namespace lostopos::test
