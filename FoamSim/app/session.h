#pragma once

#include "Console/interrupt_guard.h"
#include "Console/progress.h"
#include "Console/thread_limit.h"
#include "FoamSim/run/run.h"

namespace foamsim::app {

using console::InterruptGuard;
using console::ThreadLimit;

/// Shows how far a simulation is.
class Progress : public console::Progress {
 public:
  using console::Progress::Progress;
  using console::Progress::show;
  void show(const Metrics& metrics, double fraction) { show(metrics.step, metrics.time, fraction); }
};

/// Hooks that show progress and ask for interruption.
RunHooks hooks_for(Progress& progress);

}  // namespace foamsim::app
