#pragma once

#include <filesystem>
#include <map>

namespace foamsim {

/// Changes of topology in a stretch of time.
struct EventCounts {
  long t1 = 0;        ///< separations of regions at a vertex
  long bursts = 0;    ///< films that burst
  long vanished = 0;  ///< regions that became too small for the mesh
};

/// The events of a run by step, from its events.csv.
class RunEvents {
 public:
  /// Throws base::InputError with file and line where the table is none of a run, base::FileError.
  explicit RunEvents(const std::filesystem::path& events_csv);
  /// Those after one step up to another, that included.
  EventCounts between(long after, long until) const;

 private:
  std::map<long, EventCounts> by_step_;
};

}  // namespace foamsim
