#pragma once

#include <pybind11/numpy.h>

#include "FoamSim/run/scene_motion.h"
#include "Python/bindings/signals.h"

namespace foamsim::python {

/// A simulation in Python's hands: made, stepped, looked into and changed between steps. All its functions are called
/// with the interpreter's lock, which steps let go.
class Session {
 public:
  explicit Session(const Scene& scene);
  Session(const std::filesystem::path& checkpoint, const std::shared_ptr<Catalogue>& catalogue);
  Session(const Session&) = delete;
  Session& operator=(const Session&) = delete;
  ~Session() = default;

  /// One step; undone where it throws: what the library or a Python callback throws, or what a signal's handler raised.
  /// Throws base::Error while arrays look into the surface.
  void step();
  /// Changes an option: the simulation is made anew from its state. Where that throws (base::InputError for what does
  /// not fit), all is as before.
  void set(const std::string& key, const pybind11::handle& value);
  /// Throws base::Error while a step is being made.
  const SceneMotion& motion() const;
  void save(const std::filesystem::path& checkpoint) const;

  /// An array that looks into the surface, or into an attribute of it, and keeps the simulation's memory alive.
  pybind11::array view(const pybind11::dtype& type, const std::vector<pybind11::ssize_t>& shape, const void* data,
                       bool writable) const;

 private:
  SceneMotion::Beginning begin(const std::function<SceneMotion::Beginning(const base::Interruption&)>& make);
  base::Interruption interruption() const;

  std::shared_ptr<SignalWatch> watch_ = std::make_shared<SignalWatch>();
  std::shared_ptr<const Catalogue> catalogue_;
  std::shared_ptr<SceneMotion> motion_;
  std::shared_ptr<long> views_ = std::make_shared<long>(0);
  bool stepping_ = false;
};

}  // namespace foamsim::python
