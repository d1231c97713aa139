#include "FoamSim/sheet/velocity/biot_savart.h"

#include <array>
#include <cmath>
#include <string>

#include "Base/error.h"
#include "FoamSim/sheet/velocity/direct.h"

namespace foamsim {
namespace {

struct Entry {
  std::string_view name;
  std::unique_ptr<BiotSavart> (*make)();
};

template <class Summation>
std::unique_ptr<BiotSavart> make() {
  return std::make_unique<Summation>();
}

// One line registers a summation.
constexpr std::array kEntries{
    Entry{"direct", &make<DirectBiotSavart>},
};

}  // namespace

void BiotSavart::check_arguments(const VortexSources& sources, std::span<const lostopos::Vec3> targets, double delta,
                                 std::span<const lostopos::Vec3> out) {
  if (!std::isfinite(delta) || delta < 0) {
    throw base::InputError("Biot-Savart: regularisation delta = " + std::to_string(delta) +
                           "; it must be a finite length >= 0");
  }
  if (out.size() != targets.size()) {
    throw base::InputError("Biot-Savart: " + std::to_string(targets.size()) + " targets, but room for " +
                           std::to_string(out.size()) + " velocities; there must be one a target");
  }
  const std::size_t n = sources.size();
  for (const auto* array : {&sources.y, &sources.z, &sources.gx, &sources.gy, &sources.gz}) {
    if (array->size() != n) {
      throw base::InputError("Biot-Savart: the arrays of the sources have " + std::to_string(n) + " and " +
                             std::to_string(array->size()) + " entries; all must have the same length");
    }
  }
}

std::unique_ptr<BiotSavart> make_biot_savart(std::string_view name) {
  std::string valid;
  for (const Entry& entry : kEntries) {
    if (entry.name == name) return entry.make();
    valid += (valid.empty() ? "" : ", ") + std::string(entry.name);
  }
  throw base::InputError("unknown Biot-Savart summation '" + std::string(name) + "'; valid names: " + valid);
}

std::vector<std::string_view> biot_savart_names() {
  std::vector<std::string_view> names;
  names.reserve(kEntries.size());
  for (const Entry& entry : kEntries) names.push_back(entry.name);
  return names;
}

}  // namespace foamsim
