#include "FoamSim/scenes/reference_options.h"

#include <algorithm>
#include <filesystem>

#include "Base/error.h"

namespace foamsim {

using base::OptionSet;
using lostopos::ReferenceKey;
using lostopos::ReferenceValues;

namespace {

std::vector<ReferenceKey> film_keys() {
  using enum lostopos::KeyUse;
  return {
      {"scene", "", converted, "the scene", "the same names"},
      {"load-dir", "", converted, "load_dir",
       "seen from the working folder, or from the file's; foam and pullingfoam make a start of their own where it has "
       "no "
       "mesh001000.rec"},
      {"time-step", "0.01", as_it_is, "dt", "a step is a dynamics tick and a remeshing tick"},
      {"simulation-time", "1", converted, "time", "half of it: its clock runs through both ticks"},
      {"implicit-integration", "0", converted, "integrator", "1: implicit"},
      {"pbd-implicit", "0", converted, "integrator",
       "1, with implicit-integration: pbd; alone it has no effect, as there"},
      {"RK4-velocity-integration", "0", converted, "integrator",
       "1: rk4, where the scheme is not implicit; there it has no effect, since the positions that it finds are thrown "
       "away"},
      {"smoothing-coef", "10", converted, "diffusion", "twice of it: it acts on both ticks; 0: not an effect"},
      {"damping-coef", "1", converted, "damping, rod_damping",
       "the same, once a step; 1: not an effect; of rods: drag"},
      {"sigma", "1", as_it_is, "sigma", ""},
      {"gravity", "0", converted, "gravity", "of rods alone, which is so there too"},
      {"fmmtl", "1", converted, "velocity",
       "1: auto, whose sums over many triangles are by tree, as theirs are by fast multipoles; 0: direct"},
      {"looped", "1", converted, "looped", "of rods, in the reference's units (reference_units)"},
      {"radius", "5e-5", converted, "rod_radius", "of rods"},
      {"density", "1320", converted, "rod_density", "of rods"},
      {"stretching", "5000", converted, "stretching", "of rods"},
      {"bending", "250", converted, "bending", "of rods"},
      {"output-mesh", "0", converted, "rec_every", "1: rec/mesh000000.rec, ..., beside our frames, numbered by ticks"},
      {"output-mesh-every-n-frames", "0", converted, "rec_every",
       "half of it, a step being two frames; an odd number: every second of its frames; 0: each step"},
      {"output-obj", "0", converted, "obj_every", "1: obj/mesh000000.obj, ..., with normals"},
      {"output-obj-every-n-frames", "0", converted, "obj_every", "as for output-mesh"},
      {"mesh-size-n", "", as_it_is, "n", ""},
      {"mesh-size-m", "", as_it_is, "m", ""},
      {"foam-burst-start", "10", converted, "burst_start", "half of it"},
      {"foam-burst-interval", "20", converted, "burst_interval", "half of it"},
  };
}

bool contains(const std::vector<std::string>& words, std::string_view word) {
  return std::ranges::find(words, word) != words.end();
}

// Fills a scene from the values of a file.
class Reading {
 public:
  Reading(const ReferenceValues& values, Scene& scene) : values_(values), scene_(scene), options_(scene.options) {}

  void go() {
    set_effects();
    set_times();
    set_integrator();
    set_sizes();
    set_rod();
    set_outputs();
    for (std::string& note : lostopos::set_tracker_options(values_, options_)) scene_.notes.push_back(std::move(note));
    values_.set("fmmtl", "velocity", std::string(values_.flag("fmmtl") ? "auto" : "direct"), options_);
    set_start();
    values_.set_as_it_is("remeshing-resolution", "resolution", options_);
    options_.set_default("resolution_mean", std::string("triangle-sides"));
  }

 private:
  void note(std::string_view key, const std::string& what) {
    scene_.notes.push_back(values_.where(key) + ": '" + std::string(key) + "' " + what);
  }

  // Whether the scene has what reads the option.
  bool is_used(std::string_view ours) const {
    if (!options_.has(ours)) return false;
    const auto& [kind, name] = std::ranges::find(options_.specs(), ours, &base::OptionSpec::key)->owner;
    if (kind == "effect") return contains(options_.words("effects"), name);
    if (kind == "constraint") return contains(options_.words("constraints"), name);
    return true;
  }

  void set_where_used(std::string_view key, std::string_view ours, double factor) {
    if (is_used(ours))
      values_.set(key, ours, factor * values_.number(key), options_);
    else
      note_unused(key);
  }

  void note_unused(std::string_view key) {
    if (values_.given(key)) note(key, "means nothing in the scene " + scene_.name);
  }

  void set_effects() {
    std::vector<std::string> effects = options_.words("effects");
    const auto have = [&](const char* effect, bool wanted) {
      std::erase(effects, effect);
      if (wanted) effects.emplace_back(effect);
    };
    const double smoothing = values_.number("smoothing-coef"), damping = values_.number("damping-coef");
    have("surface_tension", true);
    have("damping", damping != 1);
    have("diffusion", smoothing != 0);
    // As defaults: conservative dynamics, where somebody asks for these, leave diffusion out.
    options_.set_default("effects", effects);
    if (smoothing < 0) throw base::InputError(values_.where("smoothing-coef") + ": smoothing-coef has to be >= 0");
    if (smoothing != 0) options_.set_default("diffusion", 2 * smoothing);
    values_.set_as_it_is("sigma", "sigma", options_);
    if (damping != 1) values_.set("damping-coef", "damping", damping, options_);
  }

  void set_times() {
    values_.set_as_it_is("time-step", "dt", options_);
    values_.set("simulation-time", "time", values_.number("simulation-time") / 2, options_);
    set_where_used("foam-burst-start", "burst_start", 0.5);
    set_where_used("foam-burst-interval", "burst_interval", 0.5);
  }

  void set_integrator() {
    const bool implicit = values_.flag("implicit-integration"), pbd = values_.flag("pbd-implicit"),
               rk4 = values_.flag("RK4-velocity-integration");
    if (pbd && !implicit) note("pbd-implicit", "has no effect without implicit-integration 1");
    if (rk4)
      note("RK4-velocity-integration", implicit ? "has no effect with implicit-integration 1"
                                                : "selects rk4 here; in the reference it has no effect, whose scheme "
                                                  "throws the positions away that it finds");
    const char* key = implicit ? (pbd ? "pbd-implicit" : "implicit-integration") : "RK4-velocity-integration";
    const char* name = implicit ? (pbd ? "pbd" : "implicit") : rk4 ? "rk4" : "euler";
    values_.set(key, "integrator", std::string(name), options_);
  }

  void set_sizes() {
    for (const auto& [key, ours] : {std::pair("mesh-size-n", "n"), std::pair("mesh-size-m", "m")}) {
      if (!values_.given(key)) continue;
      if (options_.has(ours))
        values_.set_as_it_is(key, ours, options_);
      else
        note_unused(key);
    }
  }

  void set_rod() {
    constexpr std::array keys{std::pair("gravity", "gravity"),       std::pair("looped", "looped"),
                              std::pair("radius", "rod_radius"),     std::pair("density", "rod_density"),
                              std::pair("stretching", "stretching"), std::pair("bending", "bending")};
    for (const auto& [key, ours] : keys) {
      if (is_used(ours))
        values_.set_as_it_is(key, ours, options_);
      else
        note_unused(key);
    }
    if (is_used("rod_damping")) values_.set_as_it_is("damping-coef", "rod_damping", options_);
    if (is_used("reference_units")) options_.set_default("reference_units", true);
  }

  void set_outputs() {
    set_output("output-mesh", "output-mesh-every-n-frames", "rec_every");
    set_output("output-obj", "output-obj-every-n-frames", "obj_every");
  }

  void set_output(std::string_view wanted, std::string_view interval, std::string_view ours) {
    const long frames = values_.whole(interval);
    if (frames < 0) throw base::InputError(values_.where(interval) + ": " + std::string(interval) + " has to be >= 0");
    if (!values_.flag(wanted)) return;
    if (frames % 2 == 1) note(interval, "is odd: of its frames every second falls on a step, and is written");
    values_.set(interval, ours, frames == 0 ? 1 : frames % 2 == 0 ? frames / 2 : frames, options_);
  }

  // The folder of the start mesh. What foams do without one is theirs to say.
  void set_start() {
    namespace fs = std::filesystem;
    if (!values_.given("load-dir")) return;
    if (!options_.has("load_dir")) return note_unused("load-dir");
    fs::path folder = values_.text("load-dir");
    const std::string& where = values_.where("load-dir");
    const fs::path beside = fs::path(where.substr(0, where.rfind(':'))).parent_path() / folder;
    const bool grows_its_own = options_.has("spheres");
    const char* mesh = grows_its_own ? "mesh001000.rec" : "mesh000000.rec";
    if (!fs::exists(folder / mesh) && fs::exists(beside / mesh)) folder = beside;
    if (grows_its_own && !fs::exists(folder / mesh))
      return note("load-dir", "has no mesh001000.rec in it (" + folder.string() + ")");
    options_.set("load_dir", folder.string(), where);
  }

  const ReferenceValues& values_;
  Scene& scene_;
  OptionSet& options_;
};

}  // namespace

const std::vector<ReferenceKey>& reference_keys() {
  static const std::vector<ReferenceKey> keys = [] {
    std::vector<ReferenceKey> all = film_keys();
    for (const ReferenceKey& key : lostopos::tracker_reference_keys(false)) all.push_back(key);
    return all;
  }();
  return keys;
}

Scene read_reference_options(const std::string& file, std::shared_ptr<const Catalogue> catalogue) {
  const ReferenceValues values(file, reference_keys());
  if (!values.given("scene")) throw base::InputError(file + ": an option file needs a line 'scene NAME'");
  Scene scene = [&] {
    try {
      return built_in_scene(values.text("scene"), std::move(catalogue));
    } catch (const base::InputError& error) {
      throw base::InputError(values.where("scene") + ": " + error.what());
    }
  }();
  Reading(values, scene).go();
  return scene;
}

}  // namespace foamsim
