#pragma once

#include <string>
#include <vector>

#include "FoamSim/studies/stability/record.h"
#include "FoamSim/studies/stability/stability_case.h"

namespace foamsim {

struct StabilityOptions {
  std::vector<std::string> cases{};                                      ///< names; empty: all
  std::vector<std::string> areas{"naive", "constant-edge", "averaged"};  ///< strategies
  std::vector<bool> remeshing{true, false};
  double steps_scale = 1;                  ///< multiplies the steps of cases that may be shortened, in (0, 10]
  std::vector<std::string> assignments{};  ///< "key=value": options that every simulation is run with
  double most_seconds = 900;               ///< wall time of one motion; a longer one is stopped and fails; > 0
};

/// One combination of case, strategy and remeshing: what came of it.
struct StabilityRow {
  std::string name, area;  ///< area: "-" where no strategy acts
  bool remeshing = true;
  Verdict verdict;
  PhysicsFigures physics;           ///< the largest over the case's motions
  long steps = 0, steps_asked = 0;  ///< over the case's motions
  double time = 0;                  ///< simulated by the last of them, T
  std::size_t triangles = 0;        ///< at its end
  double seconds = 0;               ///< wall time
};

/// Throws base::InputError for unknown names, options out of range, and such as one of the strategies does not use.
void validate(const StabilityOptions& options);

/// What a row is of.
struct StabilityCombination {
  std::string name, area;  ///< area: of the options, also where no strategy acts
  bool remeshing = true;
};

/// Every case with every strategy and remeshing that it is for: a row each. The options are valid.
std::vector<StabilityCombination> combinations(const StabilityOptions& options);

struct StabilityHooks {
  std::function<void(const StabilityRow&)> row;                             ///< after every combination
  std::function<void(const std::string& label, double fraction)> progress;  ///< of the whole study, after every step
  std::function<bool()> interrupted;                                        ///< asked after every step
};

/// One case under one setup. A motion that fails is a verdict, not an exception. Nothing when interrupted.
std::optional<StabilityRow> run_stability_case(const StabilityCase& what, const CaseSetup& setup, double most_seconds,
                                               const RecordHooks& hooks);

/// Every combination in turn. Ends early when interrupted, without the row of the one that was being run. Validates
/// first.
std::vector<StabilityRow> study_stability(const StabilityOptions& options, const StabilityHooks& hooks = {});

}  // namespace foamsim
