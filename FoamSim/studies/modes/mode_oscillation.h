#pragma once

#include <functional>
#include <vector>

namespace foamsim {

/// A bubble that oscillates in one axisymmetric mode, without damping, diffusion and remeshing: compared with the
/// linear theory of a film of tension 4σ between equal fluids (Lamb 1932, §275),
/// ω² = 4σ n (n − 1)(n + 1)(n + 2) / ((2n + 1) R³).
struct ModeOptions {
  bool conservative = false;  ///< the dynamics: `conservative`, else `vortex-sheet` with averaged areas
  long mode = 2;              ///< n, 2 to 6
  long subdivisions = 3;      ///< of the icosahedron, 1 to 7: 20·4^subdivisions triangles
  double amplitude = 0.02;    ///< start amplitude over the radius, in (0, 0.2]
  double radius = 1;          ///< R, L, > 0
  double sigma = 1;           ///< σ, L³/T², > 0
  double dt = 0;              ///< T; 0: the smaller of 0.75 √(δ³/σ) (short waves) and 1/60 of the theory's period
  long periods = 3;           ///< how many to measure, ≥ 1
};

struct ModeSample {
  double time;                              ///< T
  double measured, theory;                  ///< amplitude a_n over the radius; theory: a_n(0) cos ωt
  double kinetic_energy, potential_energy;  ///< the latter above that at the start; L⁵/T²
};

/// One oscillation at one resolution.
struct ModeRun {
  ModeOptions options;  ///< with dt as used
  std::size_t triangles = 0;
  double resolution = 0, delta = 0;    ///< h̄ and δ, L
  double omega = 0, omega_theory = 0;  ///< angular frequency, 1/T, from the zero crossings, and in theory
  std::vector<double> half_periods;    ///< times between neighbouring zero crossings, T
  std::vector<ModeSample> samples;     ///< one a step
  double energy_drift = 0;             ///< largest |E − E(0)| over the peak kinetic energy
  double peak_kinetic_energy = 0;      ///< L⁵/T²
  double peak_impulse = 0;             ///< largest |I|, L⁴/T
  double peak_impulse_scale = 0;       ///< largest Σ|2Γ̄ area|, L⁴/T
  double peak_other_mode = 0;          ///< largest |a_k| over the radius, 1 ≤ k ≤ 6, k ≠ n
  long steps = 0;

  double frequency_error() const { return omega / omega_theory - 1; }
  double period_error() const { return omega_theory / omega - 1; }
};

struct ModeProgress {
  long mode;
  std::size_t triangles;
  double fraction;  ///< of this run, roughly
};
using ModeCallback = std::function<void(const ModeProgress&)>;

/// The theory's angular frequency (1/T).
double mode_frequency(long mode, double sigma, double radius);

/// Runs one oscillation with RK4 and measures it. The frequency comes from a straight line through all zero crossings
/// of a_n(t). Throws base::InputError for options out of range, base::Error when the surface does not
/// oscillate in four times the theory's time.
ModeRun run_mode(const ModeOptions& options, const ModeCallback& progress = {});

/// One mode at several resolutions.
struct ModeConvergence {
  std::vector<ModeRun> runs;            ///< coarse to fine
  std::vector<double> observed_orders;  ///< of |frequency error| in δ, between neighbouring runs
  double extrapolated_omega = 0;        ///< at δ → 0, by a straight line in δ through the two finest runs
  double extrapolated_error() const { return extrapolated_omega / runs.back().omega_theory - 1; }
};

/// Orders and extrapolation of two or more runs of one mode, coarse to fine. Throws base::InputError otherwise.
ModeConvergence mode_convergence(std::vector<ModeRun> runs);

/// run_mode for each number of subdivisions, ascending, at least two.
ModeConvergence study_mode(ModeOptions options, const std::vector<long>& subdivisions,
                           const ModeCallback& progress = {});

}  // namespace foamsim
