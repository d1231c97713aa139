#pragma once

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <cstddef>

// GCC's word for it, and clang's.
#if defined(__SANITIZE_THREAD__)
#define FOAMSIM_THREAD_SANITIZER
#elif defined(__has_feature)
#if __has_feature(thread_sanitizer)
#define FOAMSIM_THREAD_SANITIZER
#endif
#endif
#ifdef FOAMSIM_THREAD_SANITIZER
#include <sanitizer/tsan_interface.h>
#endif

namespace base {

/// Tells the thread sanitizer what TBB, which is not instrumented, guarantees: what was written before a loop is seen
/// in it, and what a loop wrote is seen after it. Does nothing in other builds.
class LoopOrder {
 public:
#ifdef FOAMSIM_THREAD_SANITIZER
  LoopOrder() {
    __tsan_release(&begin_);
  }
  void enter() {
    __tsan_acquire(&begin_);
  }
  void leave() {
    __tsan_release(&end_);
  }
  void done() {
    __tsan_acquire(&end_);
  }

 private:
  char begin_ = 0, end_ = 0;
#else
  void enter() {}
  void leave() {}
  void done() {}
#endif
};

/// What TBB copies and calls: its own reads are of the copy that TBB has handed on, which the sanitizer cannot know.
template <class Body>
struct OrderedBody {
  const Body& body;
  LoopOrder& order;
  __attribute__((no_sanitize_thread)) void operator()(const tbb::blocked_range<std::size_t>& range) const {
    order.enter();
    body(range.begin(), range.end());
    order.leave();
  }
};

/// Calls body(begin, end) from several threads for parts of first .. last, each of `grain` or more indices where there
/// are so many. What the body writes must depend on the indices alone: then results are the same bits for any number of
/// threads. Nobody else calls TBB's loops.
template <class Body>
void parallel_ranges(std::size_t first, std::size_t last, std::size_t grain, const Body& body) {
  LoopOrder order;
  tbb::parallel_for(tbb::blocked_range<std::size_t>(first, last, grain), OrderedBody<Body>{body, order});
  order.done();
}

/// The same for body(i), i = 0 .. count - 1.
template <class Body>
void parallel_for_each(std::size_t count, std::size_t grain, const Body& body) {
  parallel_ranges(0, count, grain, [&body](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i != end; ++i) body(i);
  });
}

}  // namespace base
