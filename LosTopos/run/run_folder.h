#pragma once

#include <filesystem>

namespace lostopos::run {

/// Where a run writes: DIR with run.json, metrics.csv, volumes.csv, events.csv, frames/, checkpoint.cbor.
class RunFolder {
 public:
  /// Makes the folder and tries that it can be written to. Throws base::InputError when it holds a run already and
  /// `force` is false (with force that run's files are removed first), or base::FileError when it cannot be made.
  static RunFolder create(const std::filesystem::path& path, bool force);
  /// The folder of an earlier run, to go on in.
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

  /// Removes what `create` made: for a run that failed before it began.
  void discard() const;

 private:
  RunFolder(std::filesystem::path path, std::filesystem::path made) : path_(std::move(path)), made_(std::move(made)) {}
  std::filesystem::path path_;
  std::filesystem::path made_;  // topmost folder that did not exist before; empty when all did
};

}  // namespace lostopos::run
