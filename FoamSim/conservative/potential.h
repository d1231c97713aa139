#pragma once

#include <boost/container/small_vector.hpp>
#include <span>
#include <vector>

#include "FoamSim/conservative/film_connectivity.h"
#include "FoamSim/sheet/circulation.h"

namespace foamsim {

/// φ of one region at one vertex, L²/T; only differences between the regions of a vertex mean anything: Γ^{pq} = φ^p −
/// φ^q, closed by construction.
struct RegionPotential {
  lostopos::Region region;
  double value;
};

/// What one vertex holds, ascending by region.
using VertexPotential = boost::container::small_vector<RegionPotential, 2>;

/// φ of region r; null where it is not held.
const double* find(const VertexPotential& potential, lostopos::Region r);

/// Whether it is what a vertex can hold: regions in ascending order, each once, with finite values.
bool is_sound(const VertexPotential& potential);

/// (1 − t) a + t b for every region that both hold, levelled first so that constants do not matter; a region that one
/// holds comes from it.
VertexPotential interpolate(const VertexPotential& a, const VertexPotential& b, double t);

/// The attribute "potential" of a mesh, carried through operations by PotentialTransfer.
class PotentialField {
 public:
  /// Of `mesh`, which must outlive the field's use; zero unless values of that name wait in the mesh. `conserving`,
  /// `delta`: see PotentialTransfer.
  PotentialField(lostopos::SurfaceMesh& mesh, bool conserving);

  /// Whether no vertex holds anything but zero: a surface that has not moved yet.
  bool at_rest() const;
  /// By entry of `films`; entries that a vertex does not hold are 0.
  void gather(const FilmConnectivity& films, std::span<double> phi) const;
  /// Makes the vertices hold exactly what is given.
  void scatter(const FilmConnectivity& films, std::span<const double> phi);

 private:
  lostopos::VertexAttribute<VertexPotential> values_;
};

/// Sets Γ^{pq} = φ^p − φ^q wherever `circulation` holds the pair.
void put_circulation(const FilmConnectivity& films, std::span<const double> phi, CirculationField& circulation);

/// Adds to φ, at every vertex by least squares, what `circulation` has become other than φ's own Γ: what effects that
/// know of Γ alone have done.
void take_circulation(const FilmConnectivity& films, const CirculationField& circulation, std::span<double> phi);

}  // namespace foamsim

/// Stored as the number of regions at each vertex, and behind these the values.
template <>
struct lostopos::AttributeCodec<foamsim::VertexPotential> {
  static std::string type() { return "potential"; }
  static void encode(std::span<const foamsim::VertexPotential> values, std::vector<std::uint8_t>& bytes);
  static std::optional<std::vector<foamsim::VertexPotential>> decode(std::span<const std::uint8_t> bytes);
  static constexpr int components = 0;
};
