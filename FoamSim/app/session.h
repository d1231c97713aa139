#pragma once

#include "Base/console/interrupt_guard.h"
#include "Base/console/progress.h"
#include "Base/console/thread_limit.h"
#include "FoamSim/run/run.h"

namespace foamsim::app {

using base::InterruptGuard;
using base::Progress;
using base::ThreadLimit;

/// Throws base::InputError for a number of threads (of --threads) below 0.
void require_threads(int threads);
/// The same; 0: all cores.
ThreadLimit thread_limit(int threads);

/// Hooks that show progress and ask for interruption.
RunHooks hooks_for(Progress& progress);

}  // namespace foamsim::app
