#pragma once

#include "FoamSim/effects/effect.h"
#include "Python/bindings/held_object.h"

namespace foamsim::python {

/// An effect that Python wrote: an object with the hooks of foamsim.Effect. What these get are copies, so that they may
/// keep them; what they return is checked. Exceptions pass through, and the step is undone.
class PythonEffect final : public Effect {
 public:
  /// `object`: an instance of foamsim.Effect. To be called with the interpreter's lock.
  PythonEffect(std::string name, pybind11::object object);

  std::string_view name() const override { return name_; }
  void attach(lostopos::SurfaceMesh& mesh) override;
  std::vector<lostopos::Region> bursts(const EffectStep& step) override;
  bool lets_burst() const override { return lets_burst_; }
  std::vector<lostopos::Vec3> displaced(const EffectStep& step) override;
  void update_circulation(const EffectStep& step, CirculationField& circulation) override;
  void add_force(const Stage& stage, std::span<lostopos::Vec3> force) override;
  void add_velocity(const Stage& stage, std::span<lostopos::Vec3> velocity) override;
  void move_vertices(const Stage& stage, std::span<lostopos::Vec3> positions) override;
  double potential_energy(const SurfaceGeometry& geometry) const override;
  double potential_energy(const Stage& stage) const override;
  nlohmann::json state() const override;
  void restore(const nlohmann::json& state) override;

 private:
  pybind11::object call(const char* hook, const EffectStep& step, double time,
                        std::span<const lostopos::Vec3> positions) const;
  std::string result_of(const char* hook) const;

  std::string name_;
  HeldObject object_;
  bool lets_burst_;
  std::vector<lostopos::VertexAttribute<double>> attributes_;
  const lostopos::SurfaceMesh* mesh_ = nullptr;
};

}  // namespace foamsim::python
