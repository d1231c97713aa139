#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "LosTopos/io/surface_data.h"

namespace foamsim::web {

/// A bubble of one surface.
struct BubbleMeasures {
  std::uint32_t region;
  double volume;          ///< L³; NaN where films alone do not close it
  double area;            ///< of its films, L²
  double pressure;        ///< over the tension of a film, 1/L, against the air; NaN where films do not say it
  std::uint32_t faces;    ///< films that bound it
  lostopos::Vec3 centre;  ///< area-weighted, L
};

/// What is seen of a surface: its Plateau borders, bubbles, and fields that follow from its shape.
struct SurfaceMeasures {
  std::vector<std::array<std::uint32_t, 2>> borders;  ///< edges of more than two films' triangles, ascending
  /// By triangle, 1/L; of films, the mean over the corners where it is defined (inside of a film), NaN where there is
  /// none. Positive where the film bulges out of the region with the higher number.
  std::vector<double> mean_curvature;
  /// By triangle, 1/L: twice the mean curvature averaged over the whole film, by Young and Laplace's law the pressure
  /// of the region with the higher number less that of the other, over the film's tension.
  std::vector<double> pressure_jump;
  std::vector<BubbleMeasures> bubbles;  ///< ascending by region; not the air
};

/// Measures a surface; triangles whose array "solid" is not 0 are not films. Mean curvatures are those of the area's
/// gradient, Pinkall and Polthier 1993. Bubbles are those of `foam_statistics`.
SurfaceMeasures measure(const lostopos::SurfaceData& surface);

}  // namespace foamsim::web
