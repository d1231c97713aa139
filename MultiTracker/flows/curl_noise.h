#pragma once

#include <array>
#include <cstdint>

#include "MultiTracker/flows/flow.h"

namespace multitracker {

/// A random flow that is free of divergence exactly and steady: the curl of a vector potential of waves with random
/// directions, phases and amplitudes (after Bridson, Houriham, Nordenstam 2007, "Curl-noise for procedural fluid
/// flow"; waves in the place of their lattice noise, for an exact derivative). The same seed gives the same bits.
class CurlNoiseFlow final : public Flow {
 public:
  /// `speed`: root mean square of the velocity over space, L/T; `wavelength`: the longest, L, the shortest is half.
  CurlNoiseFlow(std::uint64_t seed, double speed, double wavelength);
  lostopos::Vec3 velocity(const lostopos::Vec3& x, double time) const override;

 private:
  struct Wave {
    lostopos::Vec3 number;     ///< 2π over its length along its direction, 1/L
    lostopos::Vec3 amplitude;  ///< of the velocity, perpendicular to `number`
    double phase;
  };
  static constexpr std::size_t wave_count = 16;
  std::array<Wave, wave_count> waves_;
};

}  // namespace multitracker
