#include "FoamSim/app/web_arguments.h"

namespace foamsim::app {

void add_run_folder(base::Command& command, std::string& run) {
  command.add({.name = "run",
               .target = &run,
               .help = "folder of the run",
               .required = true,
               .offers = base::Argument::Offers::folders});
}

void add_frame_options(base::Command& command, std::vector<std::string>& fields, std::string& precision) {
  command.add({.name = "--fields",
               .target = &fields,
               .help =
                   "mean_curvature, pressure_jump and what the run's vtp/ has, separated by commas; none; all unless "
                   "given"});
  command.add({.name = "--precision",
               .target = &precision,
               .help = "quantised (positions and fields in 65,535 steps of their range), or single (32-bit numbers)",
               .names = {"quantised", "single"},
               .names_only = true});
}

web::Precision precision_of(const std::string& name) {
  return name == "single" ? web::Precision::single : web::Precision::quantised;
}

}  // namespace foamsim::app
