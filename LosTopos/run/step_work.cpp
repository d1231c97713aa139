#include "LosTopos/run/step_work.h"

namespace lostopos::run {

void StepWork::add(const StepWork& step) {
  times.add(step.times);
  move += step.move;
  topology += step.topology;
  topology.events.clear();
  remesh += step.remesh;
}

}  // namespace lostopos::run
