#include <array>

#include "Base/names/nearest_name.h"
#include "FoamSim/studies/stability/cases/cases.h"

namespace foamsim {

std::span<const StabilityCase> stability_cases() {
  using namespace stability;
  static const std::array cases{
      long_double_bubble(),   volume_ratio(),     stretched_border(), border_slivers(),   time_steps(),
      displaced_quad_point(), meeting_off_axis(), t1_threshold(),     shrinking_bubble(), scaled_lengths(),
      moved_origin(),         vertex_noise(),     random_foam(),      fine_foam(),        large_foam(),
  };
  return cases;
}

const StabilityCase& stability_case_by_name(std::string_view name) {
  return base::find_by_name(stability_cases(), name, "stability case");
}

}  // namespace foamsim
