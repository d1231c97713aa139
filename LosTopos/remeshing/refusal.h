#pragma once

#include <cstddef>
#include <cstdint>

namespace lostopos {

/// Why an operation was not done. A refused operation has left the mesh as it was, to the bit.
enum class Refusal : std::uint8_t {
  held,               ///< a held vertex would move or go, or an edge between held vertices would change
  junction_topology,  ///< junction curves would be joined, cut, shortened to nothing or pulled off their place
  link_condition,     ///< the neighbourhood would not stay what it is topologically (a duplicate edge or triangle)
  labels,             ///< the films on the two sides do not separate the same two regions
  small_angle,        ///< an angle below its bound, and smaller than before
  large_angle,        ///< an angle above its bound, and larger than before
  small_area,         ///< an area below its bound, and smaller than before
  long_edge,          ///< an edge above its bound, and longer than before
  inverted_normal,    ///< a triangle would turn over
  volume_change,      ///< a region would gain or lose more than its bound
  intersection,       ///< the surface would touch or pass through itself on the way
  not_better,         ///< the change would be allowed but improves nothing
  ambiguous,          ///< a region meets itself around an edge, so that it is not clear what would become of it
};
inline constexpr std::size_t refusal_count = 13;

/// A few words, for tables.
const char* name(Refusal refusal);

}  // namespace lostopos
