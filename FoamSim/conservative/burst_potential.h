#pragma once

#include <map>
#include <span>
#include <vector>

#include "FoamSim/conservative/film_shape.h"

namespace foamsim {

/// φ of the films that are left when a region bursts. The air's φ becomes, where the region was, the region's own,
/// shifted by one constant (which moves nothing) to meet the air's in the mean over the border of the broken films; at
/// that border it is the mean of both by the areas of the films that they have there, and then changed by the least in
/// the mean square over area that keeps the impulse Σ 2Γ̄ N of all films that are left, and ∫ Γ dA of those between the
/// air and each other region: as if the broken films had only gone.
class BurstPotential {
 public:
  /// Before the burst. `phi`: by entry of `films`.
  BurstPotential(const FilmConnectivity& films, const FilmShape& shape, std::span<const double> phi,
                 lostopos::Region bursting);

  /// After it: sets the air's entries of `phi` (by entry of the films that are left, the others as they were).
  void finish(const FilmConnectivity& films, const FilmShape& shape, std::span<double> phi) const;

 private:
  // What is kept: impulse, and ∫ Γ dA of the air's films to each region.
  struct Kept {
    lostopos::Vec3 impulse = lostopos::Vec3::Zero();
    std::map<lostopos::Region, double> integrals;
  };
  void find_border(const FilmConnectivity& films, const FilmShape& shape, std::span<const double> phi,
                   lostopos::Region bursting);
  void join(const FilmConnectivity& films, std::span<const double> phi, lostopos::Region bursting);
  void change_border(const FilmConnectivity& films, const FilmShape& shape, std::span<double> phi) const;
  // `second`: counts as the air, and its films to the air not at all; the air itself: nothing does.
  static Kept kept(const FilmConnectivity& films, const FilmShape& shape, std::span<const double> phi,
                   lostopos::Region second);

  // Areas of films at a vertex: the air's and the bursting region's, without those between the two.
  struct Border {
    double outside = 0, inside = 0;
    double area() const { return outside + inside; }
  };
  Kept kept_;
  std::vector<double> joined_;  // the air's φ, by vertex slot
  std::vector<Border> border_;  // by vertex slot; of the broken films' border, where φ is free to change
  double level_ = 0;            // by which φ of the region is shifted
};

}  // namespace foamsim
