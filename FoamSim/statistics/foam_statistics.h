#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "FoamSim/statistics/film_network.h"

namespace foamsim {

/// A bubble as a cell of the foam: faces are films, edges Plateau borders, vertices Plateau vertices. For a cell
/// without holes whose faces are discs, vertices − (edges − loops) + faces = 2 (Euler).
struct BubbleStatistics {
  lostopos::Region region;
  std::optional<double> volume;    ///< L³; none where solids or open films bound it
  double area = 0;                 ///< of its films, L²
  double air_area = 0;             ///< the part of it that touches the air, L²
  std::size_t faces = 0;           ///< films
  std::size_t edges = 0;           ///< Plateau borders
  std::size_t loops = 0;           ///< those among them that are closed in themselves
  std::size_t vertices = 0;        ///< Plateau vertices
  std::size_t neighbours = 0;      ///< other bubbles that share a film with it
  std::optional<double> pressure;  ///< see `bubble_pressures`
};

/// Mean and standard deviation of a list; none where it is empty.
struct Spread {
  std::optional<double> mean, deviation;
};
Spread spread_of(std::span<const double> values);

/// A foam at one time.
struct FoamStatistics {
  std::vector<BubbleStatistics> bubbles;  ///< ascending by region; the air is none
  FilmNetwork network;

  double film_area() const;      ///< L²
  double border_length() const;  ///< L
  /// Bubbles that do not touch the air.
  std::size_t inner_bubbles() const;
  Spread volumes() const;
  /// How unequal the bubbles are: R₃₂ / ⟨R³⟩^(1/3) − 1, R the radius of a sphere of the bubble's volume and R₃₂ =
  /// ⟨R³⟩/⟨R²⟩ (Kraynik, Reinelt, van Swol 2004); 0 for equal ones.
  std::optional<double> polydispersity() const;
  Spread faces() const;
  /// Of the bubbles that do not touch the air, as theory has them: 13.4 in random foams, 14 in Kelvin's.
  Spread inner_faces() const;
  /// Plateau borders of a film.
  Spread film_edges() const;
  Spread neighbours() const;
  Spread pressures() const;
};

/// Counts and measures the films of a surface. `solid` by triangle slot: not zero for those that are no film; may be
/// empty.
FoamStatistics foam_statistics(const lostopos::SurfaceMesh& mesh, std::span<const std::uint8_t> solid = {});

}  // namespace foamsim
