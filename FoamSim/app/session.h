#pragma once

#include "Base/console/interrupt_guard.h"
#include "Base/console/progress.h"
#include "Base/console/thread_limit.h"
#include "FoamSim/run/run.h"

namespace foamsim::app {

using base::InterruptGuard;
using base::ThreadLimit;

/// Shows how far a simulation is.
class Progress : public base::Progress {
 public:
  using base::Progress::Progress;
  using base::Progress::show;
  void show(const Metrics& metrics, double fraction) { show(metrics.step, metrics.time, fraction); }
};

/// Throws base::InputError for a number of threads (of --threads) below 0; 0: all cores.
ThreadLimit thread_limit(int threads);

/// Hooks that show progress and ask for interruption.
RunHooks hooks_for(Progress& progress);

}  // namespace foamsim::app
