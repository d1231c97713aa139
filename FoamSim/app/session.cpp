#include "FoamSim/app/session.h"

namespace foamsim::app {

RunHooks hooks_for(Progress& progress) {
  return {[&progress](const Metrics& metrics, double fraction) { progress.show(metrics, fraction); },
          [] { return InterruptGuard::interrupted(); }};
}

}  // namespace foamsim::app
