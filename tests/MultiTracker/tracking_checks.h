#pragma once

#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

#include "Base/error.h"
#include "MultiTracker/run/tracking.h"

namespace multitracker::test {

using Settings = std::vector<std::string>;  ///< key=value

inline base::OptionSet options_with(const SceneEntry& scene, const Settings& settings) {
  base::OptionSet options = options_of(scene);
  for (const std::string& setting : settings) options.set_assignment(setting, "test");
  return options;
}

/// A scene with some settings, at its start.
inline Tracking start(std::string_view name, const Settings& settings = {}) {
  const SceneEntry& scene = scene_by_name(name);
  return Tracking(Origin{.scene = &scene, .options = options_with(scene, settings)});
}

/// Does a step and expects a clean audit; false when something is wrong, so that a loop can stop.
inline bool step_and_audit(Tracking& tracking) {
  try {
    tracking.step();
  } catch (const base::Error& error) {
    ADD_FAILURE() << "step " << tracking.metrics().step + 1 << ": " << error.what();
    return false;
  }
  const lostopos::AuditReport report = tracking.audit();
  EXPECT_EQ(report.text(), "clean") << "after step " << tracking.metrics().step;
  return report.clean();
}

inline double volume_of(const lostopos::SurfaceMesh& mesh, std::size_t region) {
  for (const auto& [r, volume] : lostopos::region_volumes(mesh))
    if (r == lostopos::Region(region)) return volume;
  return 0;
}

inline bool have_film(const lostopos::SurfaceMesh& mesh, std::size_t a, std::size_t b) {
  for (lostopos::Triangle t : mesh.triangles())
    if (mesh.labels(t).has(lostopos::Region(a)) && mesh.labels(t).has(lostopos::Region(b))) return true;
  return false;
}

}  // namespace multitracker::test
