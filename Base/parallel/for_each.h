#pragma once

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <cstddef>

namespace base {

/// Calls body(i) for i = 0 .. count - 1 from several threads, `grain` or more at a time from each. What the body writes
/// must depend on i alone: then results are the same bits for any number of threads.
template <class Body>
void parallel_for_each(std::size_t count, std::size_t grain, const Body& body) {
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, count, grain),
                    [&body](const tbb::blocked_range<std::size_t>& range) {
                      for (std::size_t i = range.begin(); i != range.end(); ++i) body(i);
                    });
}

}  // namespace base
