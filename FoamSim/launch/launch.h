#pragma once

#include <memory>

#include "Base/parallel/ranks.h"

namespace foamsim {

/// The processes that were started together with this one, for the length of the program.
class Launch {
 public:
  virtual ~Launch() = default;
  virtual std::shared_ptr<const base::Ranks> ranks() const = 0;
  /// What main returns, once this process has come to `exit_code`. Where that is not 0 it ends the others too.
  virtual int end(int exit_code) = 0;
};

/// By MPI, where this program was started by its launcher (launch_mpi.cpp). In a build without MPI (launch_alone.cpp)
/// always one process; throws base::InputError where a launcher has started several.
std::unique_ptr<Launch> launch(int& argc, char**& argv);

}  // namespace foamsim
