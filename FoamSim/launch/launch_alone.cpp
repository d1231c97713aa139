// Builds without MPI.
#include <cstdlib>
#include <string>

#include "Base/error.h"
#include "FoamSim/launch/launch.h"

namespace foamsim {

namespace {

class OneProcess final : public Launch {
 public:
  std::shared_ptr<const base::Ranks> ranks() const override { return base::alone(); }
  int end(int exit_code) override { return exit_code; }
};

}  // namespace

std::unique_ptr<Launch> launch(int& /*argc*/, char**& /*argv*/) {
  for (const char* variable : {"OMPI_COMM_WORLD_SIZE", "PMI_SIZE"})
    if (const char* size = std::getenv(variable); size != nullptr && std::string(size) != "1")
      throw base::InputError("started " + std::string(size) +
                             " times by an MPI launcher, but built without MPI, so that each would do all of the work; "
                             "install libopenmpi-dev and configure again, or start it once");
  return std::make_unique<OneProcess>();
}

}  // namespace foamsim
