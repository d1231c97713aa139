#pragma once

#include <cmath>
#include <span>
#include <utility>
#include <vector>

#include "FoamSim/sheet/sheet_velocity.h"
#include "FoamSim/sheet/velocity/registry.h"
#include "LosTopos/surface_tracker.h"
#include "tests/FoamSim/constraints/made_wire.h"

namespace foamsim {

/// A surface at rest in a tracker, with everything that a wire asks for.
struct WiredFilm {
  explicit WiredFilm(lostopos::SurfaceMesh mesh)
      : tracker(std::move(mesh), {.resolution = 0.2}), circulation(tracker.mesh()) {
    geometry.update(tracker.mesh());
    // Some motion without symmetry.
    for (lostopos::Vertex v : tracker.mesh().vertices())
      for (PairCirculation& held : circulation.at(v)) {
        const lostopos::Vec3& x = tracker.mesh().position(v);
        held.value = std::sin(3 * x.x() + 1) * std::cos(2 * x.y()) + 0.3 * x.z();
      }
  }
  EffectStep step() const { return {tracker.mesh(), geometry, 0, dt, tracker.held().slots(), tracker.solid().slots()}; }
  SheetAir air() {
    return {delta, [this](std::span<const lostopos::Vertex> at, std::span<lostopos::Vec3> velocity) {
              std::vector<SheetTriangle> sheet;
              gather_sheet(tracker.mesh(), circulation, sheet, std::as_const(tracker).solid().slots());
              std::vector<lostopos::Vec3> targets;
              for (lostopos::Vertex v : at) targets.push_back(tracker.mesh().position(v));
              SheetVelocity(make_biot_savart("direct"))
                  .evaluate(sheet, tracker.mesh().positions(), targets, delta, velocity);
            }};
  }
  std::vector<lostopos::Vec3> velocities() {
    std::vector<lostopos::Vertex> all;
    for (lostopos::Vertex v : tracker.mesh().vertices()) all.push_back(v);
    std::vector<lostopos::Vec3> velocity(all.size());
    air().velocity(all, velocity);
    return velocity;
  }

  lostopos::SurfaceTracker tracker;
  CirculationField circulation;
  SurfaceGeometry geometry;
};

}  // namespace foamsim
