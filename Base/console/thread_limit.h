#pragma once

#include <tbb/global_control.h>

#include <cstddef>
#include <optional>

namespace base {

/// Limits the threads of everything that follows, while it lives; 0: no limit.
class ThreadLimit {
 public:
  explicit ThreadLimit(int threads) {
    if (threads > 0) limit_.emplace(tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(threads));
  }

 private:
  std::optional<tbb::global_control> limit_;
};

}  // namespace base
