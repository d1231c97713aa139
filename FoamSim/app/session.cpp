#include "FoamSim/app/session.h"

#include "Base/console/terminal.h"
#include "Base/error.h"

namespace foamsim::app {

void require_threads(int threads) {
  if (threads < 0) throw base::InputError("--threads has to be a whole number >= 0");
}

ThreadLimit thread_limit(int threads) {
  require_threads(threads);
  return ThreadLimit(threads);
}

RunHooks hooks_for(Progress& progress) {
  return {[&progress](long step, double time, double fraction) { progress.show(step, time, fraction); },
          [] { return InterruptGuard::interrupted(); }, [] { return InterruptGuard::interrupted(); },
          [](const std::string& note) { base::print_warning("foamsim", note); },
          [&progress](long done, long of) {
            progress.show("relaxing the start: step " + std::to_string(done) + " of " + std::to_string(of),
                          static_cast<double>(done) / static_cast<double>(of));
          }};
}

}  // namespace foamsim::app
