#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <random>
#include <string_view>

#include "LosTopos/geometry/ccd.h"
#include "tests/support/ccd_oracle.h"

namespace lostopos::test {

/// The four points of a query: vertex and triangle, or two edges.
using Query = std::array<Trajectory, 4>;

enum class Shape { vertex_triangle, edge_edge };

/// The library's answer.
std::optional<Collision> collide(Shape shape, const Query& query);

/// The oracle's.
std::optional<ExactContact> exact_contact(Shape shape, const Query& query, const OracleOptions& options = {});

/// Streams of queries, the same for the same seed.
class QueryGenerator {
 public:
  explicit QueryGenerator(std::uint64_t seed) : bits_(seed) {}

  /// Points in the unit cube that move by up to 1 along each axis.
  Query random();

  /// Cycles through families of hard queries.
  Query adversarial(Shape shape);

  /// Name of the family of the last adversarial query.
  std::string_view family() const;

 private:
  double uniform(double low, double high);
  int integer(int low, int high);
  double tiny();  // 10^-k with k from 1 to 20, or 0
  Vec3 point_in_cube();

  Query on_a_grid();
  Query coplanar();
  Query near_contact(Shape shape);
  Query grazing(Shape shape);
  Query with_shared_coordinates();
  Query collapsed();
  Query of_size(Shape shape, int exponent);
  Query scaled(Shape shape);
  Query far_from_origin(Shape shape);
  Query fast(Shape shape);
  Query rigid_neighbours(Shape shape);

  void jitter(Query& query, double size);
  void meet_at(Query& query, Shape shape, double time, bool tangentially);

  std::mt19937_64 bits_;
  unsigned count_ = 0;
};

}  // namespace lostopos::test
