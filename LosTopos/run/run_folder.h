#pragma once

#include <filesystem>
#include <optional>

#include "LosTopos/run/run_lock.h"

namespace lostopos::run {

/// Where a run writes: DIR with run.json, metrics.csv, volumes.csv, events.csv, frames/, checkpoint.cbor. It is locked
/// for others while this lives. What killed runs have left there of files that they had not finished is removed.
class RunFolder {
 public:
  /// Makes the folder and tries that it can be written to. Throws base::InputError when another run works there, or it
  /// holds a run already and `force` is false (with force that run's files are removed first), and base::FileError when
  /// it cannot be made.
  static RunFolder create(const std::filesystem::path& path, bool force);
  /// The folder of an earlier run, to go on in. Throws base::InputError when another run works there, base::FileError.
  static RunFolder open(const std::filesystem::path& path);

  std::filesystem::path path() const { return path_; }
  std::filesystem::path run_json() const { return path_ / "run.json"; }
  std::filesystem::path checkpoint() const { return path_ / "checkpoint.cbor"; }
  std::filesystem::path pvd() const { return path_ / "surface.pvd"; }
  std::filesystem::path frame(long step) const;
  std::filesystem::path vtp(long step) const;
  /// Meshes for the reference programs, under their names.
  std::filesystem::path rec(long frame) const;
  std::filesystem::path obj(long frame) const;

  /// Removes what `create` made, and gives the lock back: for a run that failed before it began.
  void discard();

 private:
  RunFolder(std::filesystem::path path, std::filesystem::path made);
  static RunFolder make(const std::filesystem::path& path, const std::filesystem::path& made);

  std::filesystem::path path_;
  std::filesystem::path made_;  // topmost folder that did not exist before; empty when all did
  std::optional<RunLock> lock_;
};

}  // namespace lostopos::run
