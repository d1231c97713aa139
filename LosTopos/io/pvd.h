#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace lostopos {

/// One frame of a ParaView collection.
struct PvdFrame {
  double time;
  std::string file;  ///< relative to the collection's folder
  bool operator==(const PvdFrame&) const = default;
};

/// Reads the frames of a ParaView collection (.pvd) in their order in the file. Throws InputError with the line when it
/// is malformed, FileError when it cannot be read.
std::vector<PvdFrame> read_pvd(const std::filesystem::path& path);

/// Writes a collection of frames. Throws InputError for a time that is not finite or a name that XML cannot hold
/// (nothing is written then), FileError when it cannot be written.
void write_pvd(const std::filesystem::path& path, const std::vector<PvdFrame>& frames);

/// A collection that grows with a run: the file is replaced, as a whole and at once, whenever a frame is added, so that
/// it can be opened at any time and lists only frames that were added.
class PvdWriter {
 public:
  /// `frames`: those to begin with, for a run that is taken up again. The file is first written by `add`.
  explicit PvdWriter(std::filesystem::path path, std::vector<PvdFrame> frames = {})
      : path_(std::move(path)), frames_(std::move(frames)) {}

  /// Adds a frame that has been written to `file` (relative to the collection's folder) and stands for `time`, in
  /// the place of one that was in the same file before. Throws as `write_pvd` does; the frame is then not added.
  void add(double time, const std::string& file);
  const std::vector<PvdFrame>& frames() const { return frames_; }

 private:
  std::filesystem::path path_;
  std::vector<PvdFrame> frames_;
};

}  // namespace lostopos
