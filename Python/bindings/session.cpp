#include "Python/bindings/session.h"

#include <nlohmann/json.hpp>
#include <utility>

#include "Base/error.h"
#include "FoamSim/run/start_checks.h"
#include "Python/bindings/option_values.h"

namespace foamsim::python {

namespace py = pybind11;

namespace {

struct View {
  std::shared_ptr<SceneMotion> motion;
  std::shared_ptr<long> views;
};

// True for as long as it lives.
class Flag {
 public:
  explicit Flag(bool& flag) : flag_(flag) { flag_ = true; }
  Flag(const Flag&) = delete;
  Flag& operator=(const Flag&) = delete;
  ~Flag() { flag_ = false; }

 private:
  bool& flag_;
};

}  // namespace

base::Interruption Session::interruption() const {
  return {[watch = watch_] { return watch->asked(); }};
}

SceneMotion::Beginning Session::begin(const std::function<SceneMotion::Beginning(const base::Interruption&)>& make) {
  std::optional<SceneMotion::Beginning> beginning;
  watch_->run([&] { beginning.emplace(make(interruption())); });
  return std::move(*beginning);
}

Session::Session(const Scene& scene) : catalogue_(scene.catalogue) {
  SceneMotion::Beginning beginning = begin([&](const base::Interruption& stop) {
    const auto go_on = [&stop](long, long) {
      stop.check();
      return true;
    };
    SceneMotion::Beginning made = SceneMotion::beginning_of(scene, go_on, stop);
    check_start(scene, made.simulation, made.start);
    return made;
  });
  motion_ = std::make_shared<SceneMotion>(std::move(beginning));
}

Session::Session(const std::filesystem::path& checkpoint, const std::shared_ptr<Catalogue>& catalogue)
    : catalogue_(catalogue) {
  motion_ = std::make_shared<SceneMotion>(
      begin([&](const base::Interruption& stop) { return SceneMotion::beginning_of(checkpoint, catalogue_, stop); }));
}

const SceneMotion& Session::motion() const {
  if (stepping_) throw base::Error("a step is being made; the simulation can be used between steps");
  return *motion_;
}

void Session::step() {
  motion();
  if (*views_ > 0)
    throw base::Error("a step would change what " + std::to_string(*views_) +
                      " arrays look into (positions, triangles, attributes); drop them, or keep copies: "
                      "numpy.array(mesh.positions)");
  const Flag stepping(stepping_);
  watch_->run([this] { motion_->step(); });
}

void Session::set(const std::string& key, const py::handle& value) {
  nlohmann::json content;
  motion().save(content);
  Checkpoint checkpoint = checkpoint_from(content, catalogue_);
  base::OptionSet& options = checkpoint.scene.options;
  set_option(options, key, value);
  if (key == "resolution" && options.number(key) > 0) checkpoint.resolution = options.number(key);
  const Flag stepping(stepping_);
  SceneMotion::Beginning beginning = begin([&](const base::Interruption& stop) {
    validate(checkpoint.scene);
    return SceneMotion::beginning_of(std::move(checkpoint), stop);
  });
  motion_ = std::make_shared<SceneMotion>(std::move(beginning));
  views_ = std::make_shared<long>(0);  // those there are look into the old one, which they keep
}

void Session::save(const std::filesystem::path& checkpoint) const {
  nlohmann::json content;
  motion().save(content);
  lostopos::run::write_checkpoint(checkpoint, checkpoint_format(), std::move(content));
}

py::array Session::view(const py::dtype& type, const std::vector<py::ssize_t>& shape, const void* data,
                        bool writable) const {
  auto owner = std::make_unique<View>(View{motion_, views_});
  const py::capsule base(owner.get(), [](void* pointer) {
    const std::unique_ptr<View> dropped(static_cast<View*>(pointer));
    --*dropped->views;
  });
  ++*views_;
  owner.release();  // NOLINT(bugprone-unused-return-value): the capsule has it
  py::array array(type, shape, data, base);
  if (!writable) array.attr("setflags")(py::arg("write") = false);
  return array;
}

}  // namespace foamsim::python
