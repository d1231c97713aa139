#pragma once

#include <functional>
#include <memory>
#include <span>
#include <string_view>
#include <vector>

#include "FoamSim/studies/stability/criteria.h"

namespace foamsim {

/// One combination under which a case runs.
struct CaseSetup {
  std::string area = "averaged";  ///< a strategy's name
  bool remeshing = true;
  double steps_scale = 1;                     ///< multiplies the steps of cases that may be shortened, > 0
  std::vector<std::string> assignments = {};  ///< "key=value", in place of the case's own but for sigma
};

/// One motion of a case; a case that compares has several.
struct CaseRun {
  std::string label;
  std::function<std::unique_ptr<MeasuredMotion>()> start;
  long steps;
};

/// Averaging: `averaged` and `border-length`, where the others are known to come apart. None: the motion is prescribed
/// and no strategy acts.
enum class Strategies { all, averaging, none };
enum class Remeshing { on_and_off, on_only };

/// A named hard case: what runs, and what has to hold.
struct StabilityCase {
  std::string_view name, summary, criterion;
  Strategies strategies = Strategies::all;
  Remeshing remeshing = Remeshing::on_and_off;
  long typical_triangles = 1000;  ///< for guesses of the time left
  bool when_named = false;        ///< takes so long that a study of all cases leaves it out
  std::vector<CaseRun> (*runs)(const CaseSetup&) = nullptr;
  Verdict (*judge)(std::span<const Trajectory>) = nullptr;  ///< of the runs, in their order
};

/// All cases. A new one is a file in cases/ and a line in the table.
std::span<const StabilityCase> stability_cases();
/// Throws base::InputError with the nearest name.
const StabilityCase& stability_case_by_name(std::string_view name);

}  // namespace foamsim
