#include "MultiTracker/scenes/reference_options.h"

#include <cmath>
#include <filesystem>
#include <numbers>

#include "Base/error.h"
#include "MultiTracker/flows/enright.h"

namespace multitracker {

using lostopos::ReferenceKey;
using lostopos::ReferenceValues;

namespace {

std::vector<ReferenceKey> tracking_keys() {
  using enum lostopos::KeyUse;
  return {
      {"scene", "", converted, "the scene", "the same names; SCENE.arec beside the file is the start surface"},
      {"load-dir", "", without, "", "the start surface comes from SCENE.arec beside the file, or from --mesh"},
      {"time-step", "0.01", converted, "dt, or period_steps", "as it is, or in parts of the flow's period"},
      {"simulation-time", "1", converted, "steps", "as many steps as make up this time"},
      {"output-mesh", "0", converted, "rec_every", "1: rec/mesh000000.rec, ..., beside our frames"},
      {"output-mesh-every-n-frames", "0", converted, "rec_every", "0: each step"},
      {"output-obj", "0", converted, "obj_every", "1: obj/mesh000000.obj, ..., with normals"},
      {"output-obj-every-n-frames", "0", converted, "obj_every", "0: each step"},
      {"mesh-size-n", "", without, "",
       "the start surfaces of our own scenes have sizes of their own (subdivisions, ...)"},
  };
}

void set_output(const ReferenceValues& values, std::string_view wanted, std::string_view interval,
                std::string_view ours, base::OptionSet& options) {
  const long frames = values.whole(interval);
  if (frames < 0) throw base::InputError(values.where(interval) + ": " + std::string(interval) + " has to be >= 0");
  if (values.flag(wanted)) values.set(interval, ours, frames == 0 ? 1L : frames, options);
}

double positive(const ReferenceValues& values, std::string_view key) {
  const double value = values.number(key);
  if (!(value > 0)) throw base::InputError(values.where(key) + ": " + std::string(key) + " has to be > 0");
  return value;
}

// How many steps of length dt are nearest to a time; `key`: the line that asks for so many.
long steps_in(double time, double dt, const ReferenceValues& values, std::string_view key) {
  constexpr double most = 1e15;
  const double steps = time / dt;
  if (!(steps <= most))
    throw base::InputError(values.where(key) + ": " + std::string(key) + " " + values.text(key) + " makes " +
                           base::to_text(steps) + " steps; at most " + base::to_text(most) + " are possible");
  return std::lround(steps);
}

void set_times(const ReferenceValues& values, const SceneEntry& scene, base::OptionSet& options) {
  const double dt = positive(values, "time-step"), time = positive(values, "simulation-time");
  long steps = steps_in(time, dt, values, "simulation-time");
  if (options.has("period_steps")) {
    const double period = scene.name == "enright" ? EnrightFlow().period() : 2 * std::numbers::pi;
    values.set("time-step", "period_steps", std::max(1L, steps_in(period, dt, values, "time-step")), options);
  } else {
    values.set("time-step", "dt", dt, options);
  }
  if (options.has("faster_later")) {
    options.set_default("faster_later", true);
    steps = StepLengths(dt).grow_from(6, 4).grow_from(30, 4).steps_to(time);
  }
  values.set("simulation-time", "steps", steps, options);
}

}  // namespace

const std::vector<ReferenceKey>& reference_keys() {
  static const std::vector<ReferenceKey> keys = [] {
    std::vector<ReferenceKey> all = tracking_keys();
    for (const ReferenceKey& key : lostopos::tracker_reference_keys(true)) all.push_back(key);
    return all;
  }();
  return keys;
}

ReferenceScene read_reference_options(const std::string& file) {
  const ReferenceValues values(file, reference_keys());
  if (!values.given("scene")) throw base::InputError(file + ": an option file needs a line 'scene NAME'");
  const SceneEntry* scene = nullptr;
  try {
    scene = &scene_by_name(values.text("scene"));
  } catch (const base::InputError& error) {
    throw base::InputError(values.where("scene") + ": " + error.what());
  }
  ReferenceScene read{scene, options_of(*scene), {}, {}};
  set_times(values, *scene, read.options);
  set_output(values, "output-mesh", "output-mesh-every-n-frames", "rec_every", read.options);
  set_output(values, "output-obj", "output-obj-every-n-frames", "obj_every", read.options);
  values.set_as_it_is("remeshing-resolution", "resolution", read.options);
  read.notes = lostopos::set_tracker_options(values, read.options);
  if (read.options.has("flow")) read.options.set_default("flow", std::string("area-gradient"));
  const auto beside = std::filesystem::path(file).parent_path() / (std::string(scene->name) + ".arec");
  if (std::filesystem::exists(beside)) read.mesh_file = beside.string();
  for (const ReferenceKey& key : reference_keys())
    if (key.use == lostopos::KeyUse::without && values.given(key.name))
      read.notes.push_back(values.where(key.name) + ": '" + std::string(key.name) +
                           "' has no meaning here: " + std::string(key.meaning));
  return read;
}

}  // namespace multitracker
