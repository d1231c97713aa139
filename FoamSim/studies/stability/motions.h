#pragma once

#include "FoamSim/studies/stability/stability_case.h"

namespace foamsim {

/// What a case changes of the double bubble scene's options.
struct SimulatedOptions {
  double dt = 0.01;       ///< T
  double resolution = 0;  ///< h̄, L; 0: the mean over the start mesh's edges
  double sigma = 1;       ///< L³/T²
  double viscosity = 1;   ///< times that of the method, L³/T, where it has one
  /// Sets Γ at the start; none: at rest.
  std::function<void(const lostopos::SurfaceMesh&, CirculationField&)> circulation = {};
};

/// Vortex-sheet dynamics from this surface, with the setup's strategy and remeshing.
std::unique_ptr<MeasuredMotion> simulated(const CaseSetup& setup, lostopos::SurfaceMesh mesh,
                                          const SimulatedOptions& options = {});

/// A motion of the tracker alone: after each dt (T) a vertex is asked to be at `flow(x)`.
std::unique_ptr<MeasuredMotion> prescribed(const CaseSetup& setup, lostopos::SurfaceMesh mesh, double dt,
                                           std::function<lostopos::Vec3(const lostopos::Vec3&)> flow);

/// `steps` times the setup's scale, at least 10.
long scaled_steps(long steps, const CaseSetup& setup);

/// The runs of a case that has one: `start` under the setup, for scaled_steps(steps).
std::vector<CaseRun> one_run(const CaseSetup& setup, std::unique_ptr<MeasuredMotion> (*start)(const CaseSetup&),
                             long steps);

}  // namespace foamsim
