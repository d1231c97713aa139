#pragma once

#include <algorithm>
#include <boost/container/small_vector.hpp>
#include <span>

#include "FoamSim/sheet/region_pair.h"
#include "LosTopos/mesh/surface_mesh.h"

namespace foamsim {

/// Γ of one region pair at one vertex, for the order (pair.low, pair.high); L²/T.
struct PairCirculation {
  RegionPair pair;
  double value;
};

/// What one vertex holds, sorted by pair.
using VertexCirculation = boost::container::small_vector<PairCirculation, 1>;

/// The entry of `pair`, or where it would have to be inserted.
template <class Values>
auto lower_bound(Values& values, RegionPair pair) {
  return std::ranges::lower_bound(values, pair, {}, &PairCirculation::pair);
}

/// Whether it is what a vertex can hold: pairs of two regions in ascending order, each once, with finite values.
bool is_sound(const VertexCirculation& values);
/// Whether `values`, sorted, are of exactly the pairs that have a triangle at v.
bool matches(std::span<const PairCirculation> values, const lostopos::SurfaceMesh& mesh, lostopos::Vertex v);

/// For each pair (1 − t) a + t b, or the value of the one that holds it.
VertexCirculation interpolate(const VertexCirculation& a, const VertexCirculation& b, double t);

/// @name On the values of all vertices, by slot
///@{
/// The mean of what the place's vertices hold: of each pair over those that hold it, by their weights.
VertexCirculation mean(std::span<const VertexCirculation> values, const lostopos::Place& place);
/// Gives v those of `given` for which it has a triangle but holds no value yet.
void add_missing(std::span<VertexCirculation> values, const lostopos::SurfaceMesh& mesh, lostopos::Vertex v,
                 const VertexCirculation& given);
/// Makes the vertices hold exactly the pairs that have a triangle there, see CirculationField::match.
void match(std::span<VertexCirculation> values, const lostopos::SurfaceMesh& mesh,
           std::span<const lostopos::Vertex> vertices);
///@}

}  // namespace foamsim

/// Stored as the number of pairs at each vertex, and behind these the pairs.
template <>
struct lostopos::AttributeCodec<foamsim::VertexCirculation> {
  static std::string type() { return "circulation"; }
  static void encode(std::span<const foamsim::VertexCirculation> values, std::vector<std::uint8_t>& bytes);
  static std::optional<std::vector<foamsim::VertexCirculation>> decode(std::span<const std::uint8_t> bytes);
  static constexpr int components = 0;
};
