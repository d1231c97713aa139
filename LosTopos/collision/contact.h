#pragma once

#include <array>
#include <compare>
#include <cstdint>

#include "LosTopos/mesh/handles.h"
#include "LosTopos/vec3.h"

namespace lostopos {

/// Two elements without a common vertex that may come into contact.
struct ElementPair {
  enum class Kind : std::uint32_t { vertex_triangle, edge_edge };
  Kind kind = Kind::vertex_triangle;
  std::uint32_t first = 0;   ///< index of the vertex, or of the edge with the smaller index
  std::uint32_t second = 0;  ///< index of the triangle, or of the other edge
  /// The vertex and the triangle's corners, or the ends of the first edge and those of the second.
  std::array<Vertex, 4> vertices = {};

  std::strong_ordering operator<=>(const ElementPair& other) const {
    if (const auto order = kind <=> other.kind; order != 0) return order;
    if (const auto order = first <=> other.first; order != 0) return order;
    return second <=> other.second;
  }
  bool operator==(const ElementPair& other) const { return (*this <=> other) == 0; }
};

/// A pair that comes too near, and what is asked of its motion: with d_i the displacement of vertex i over the step,
/// normal · Σ weights[i] d_i >= target.
struct Contact {
  ElementPair pair;
  std::array<double, 4> weights =
      {};                       ///< of the points of contact; positive on the first element, negative on the second
  Vec3 normal = Vec3::UnitX();  ///< unit, from the second element to the first
  double time = 0;              ///< fraction of the step at which they meet
  double target = 0;            ///< L
};

}  // namespace lostopos
