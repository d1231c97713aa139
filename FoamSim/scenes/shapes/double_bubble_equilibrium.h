#pragma once

#include <array>

namespace foamsim {

/// A part of a sphere from its pole to the circle where the films meet.
struct SphericalFilm {
  double radius;       ///< of the sphere, L, > 0; infinite for a flat film
  double polar_angle;  ///< from the pole to the rim, radians, 0 for a flat film
  double area;         ///< L²
};

/// The standard double bubble: three spherical films that meet at 120° along one circle, the least area that encloses
/// two volumes (Hutchings, Morgan, Ritoré, Ros 2002). Bubble 0 is the first volume given, bubble 1 the second.
struct DoubleBubbleEquilibrium {
  std::array<double, 2> volumes;       ///< as given, L³
  std::array<SphericalFilm, 2> outer;  ///< the bubbles' films towards the air
  SphericalFilm wall;                  ///< the film between the bubbles; it bulges into the larger one
  double rim_radius;                   ///< of the circle where the films meet, L

  double total_area() const { return outer[0].area + outer[1].area + wall.area; }
  /// Pressure of a bubble above the air's, for films of the given tension (both sides together; 4σ in the dynamics of
  /// docs/method.md's conventions): 2 tension / radius.
  double pressure(std::size_t bubble, double tension = 1) const { return 2 * tension / outer.at(bubble).radius; }
};

/// Closed form for equal volumes. For others the polar angles are 120° ∓ θ and θ (outer film of the smaller and of the
/// larger bubble, and wall), which follows from 120° at the rim, and θ is the one root of the ratio of volumes; it is
/// found to the last digits. Throws base::InputError unless both volumes are finite and > 0, and their ratio at
/// most 1e9.
DoubleBubbleEquilibrium double_bubble_equilibrium(double volume0, double volume1);

}  // namespace foamsim
