#pragma once

#include <string>
#include <vector>

#include "Base/io/csv_table.h"
#include "Base/timing/stopwatch.h"
#include "LosTopos/io/pvd.h"
#include "LosTopos/run/checkpoint_interval.h"
#include "LosTopos/run/run.h"
#include "LosTopos/run/run_folder.h"

namespace lostopos::run {

/// Writes a run's files at the intervals that are asked for.
class RunWriter {
 public:
  /// Makes or opens the folder, begins the tables (or cuts them back to the motion's step, to go on behind it) and
  /// writes the start. When that fails, nothing is left of the folder that was not there before. Throws
  /// base::InputError, base::FileError.
  RunWriter(const Motion& motion, const Output& output);

  /// What is due after a step.
  void write_step();
  /// The surface and the checkpoint of the end, unless the last step has written them.
  void write_end();
  void write_json(const std::string& ended, const Outcome& outcome) const;

  const RunFolder& folder() const { return folder_; }
  const std::filesystem::path& last_frame() const { return last_frame_; }
  bool saves_checkpoints() const { return saves_checkpoints_; }

 private:
  struct OpenTable {
    Table table;
    base::CsvTable file;
  };

  void begin();
  void go_on();
  std::string vtp_entry(long step) const;
  void write_rows();
  void write_frame();
  void write_reference_meshes();
  void wrote(const std::filesystem::path& file);
  void write_checkpoint();
  void wait_for_what_was_written();

  const Motion& motion_;
  const Output& output_;
  RunFolder folder_;
  std::vector<OpenTable> tables_;
  PvdWriter pvd_;
  std::filesystem::path last_frame_;
  long last_checkpoint_ = -1;
  base::Stopwatch watch_;
  CheckpointInterval checkpoint_interval_;
  std::vector<std::filesystem::path> since_checkpoint_;  // frames and meshes
  bool saves_checkpoints_ = false;
};

}  // namespace lostopos::run
