#include "FoamSim/scenes/shapes/exact_double_bubble.h"

#include <array>

#include "LosTopos/shapes/circle_films.h"

namespace foamsim {

lostopos::SurfaceMesh exact_double_bubble(const DoubleBubbleEquilibrium& e, long segments) {
  using lostopos::air;
  const lostopos::Region left(1), right(2);
  const double wall = e.volumes[0] <= e.volumes[1] ? e.wall.polar_angle : -e.wall.polar_angle;
  const std::array films{lostopos::CircleFilm{-e.outer[0].polar_angle, {air, left}},
                         lostopos::CircleFilm{e.outer[1].polar_angle, {right, air}},
                         lostopos::CircleFilm{wall, {left, right}}};
  return lostopos::films_on_circle(e.rim_radius, films, segments);
}

}  // namespace foamsim
