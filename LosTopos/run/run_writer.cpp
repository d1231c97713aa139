#include "LosTopos/run/run_writer.h"

#include <nlohmann/json.hpp>
#include <set>
#include <utility>

#include "Base/io/disk.h"
#include "Base/io/write_error.h"
#include "LosTopos/io/obj.h"
#include "LosTopos/io/ply.h"
#include "LosTopos/io/vtk_surface.h"
#include "LosTopos/run/run_json.h"

namespace lostopos::run {
namespace {

bool due(long step, long every) {
  return every > 0 && step % every == 0;
}

// What a run wrote behind the checkpoint that it is taken up from is written anew.
std::vector<PvdFrame> frames_until(const std::filesystem::path& pvd, double time) {
  std::vector<PvdFrame> frames;
  if (!std::filesystem::exists(pvd)) return frames;
  for (const PvdFrame& frame : read_pvd(pvd))
    if (frame.time <= time) frames.push_back(frame);
  return frames;
}

}  // namespace

RunWriter::RunWriter(const Motion& motion, const Output& output)
    : motion_(motion),
      output_(output),
      folder_(output.go_on ? RunFolder::open(output.folder) : RunFolder::create(output.folder, output.force)),
      pvd_(folder_.pvd()),
      checkpoint_interval_(output.checkpoint_seconds),
      saves_checkpoints_(motion.resumable()) {
  try {
    begin();
  } catch (...) {
    if (!output.go_on) folder_.discard();
    throw;
  }
}

void RunWriter::begin() {
  const long step = motion_.steps();
  for (Table& table : motion_.tables()) {
    const std::filesystem::path file = folder_.path() / table.file;
    if (output_.go_on) base::keep_rows_until(file, step);
    base::CsvTable open(file, table.header, output_.go_on);
    tables_.push_back({std::move(table), std::move(open)});
  }
  if (output_.vtp) base::make_folder(folder_.path() / "vtp");
  if (output_.rec_every > 0) base::make_folder(folder_.path() / "rec");
  if (output_.obj_every > 0) base::make_folder(folder_.path() / "obj");
  if (output_.go_on) {
    go_on();
  } else if (step == 0) {
    write_rows();
    write_frame();
    write_reference_meshes();
  }
  Outcome so_far;
  so_far.first_step = step;
  so_far.last_frame = last_frame_;
  write_json("running", so_far);
}

// A frame that a kill has cut short, its .ply there and not yet its .vtp or that one's entry, is written anew.
void RunWriter::go_on() {
  const long step = motion_.steps();
  pvd_ = PvdWriter(folder_.pvd(), frames_until(folder_.pvd(), motion_.time()));
  const bool listed = !pvd_.frames().empty() && pvd_.frames().back().file == vtp_entry(step);
  if (std::filesystem::exists(folder_.frame(step)) && (listed || !output_.vtp)) last_frame_ = folder_.frame(step);
}

std::string RunWriter::vtp_entry(long step) const {
  return folder_.vtp(step).lexically_relative(folder_.path()).string();
}

void RunWriter::write_step() {
  write_rows();
  if (due(motion_.steps(), output_.frame_every)) write_frame();
  write_reference_meshes();
  if (due(motion_.steps(), output_.checkpoint_every) || checkpoint_interval_.due(watch_.seconds())) write_checkpoint();
}

void RunWriter::write_end() {
  write_frame();
  write_checkpoint();
}

void RunWriter::write_rows() {
  for (OpenTable& open : tables_) {
    if (!due(motion_.steps(), open.table.every)) continue;
    const std::string rows = open.table.rows();
    if (!rows.empty()) open.file.add(rows);
  }
}

void RunWriter::write_frame() {
  const auto file = folder_.frame(motion_.steps());
  if (file == last_frame_) return;
  write_ply(file, motion_.frame());
  wrote(file);
  last_frame_ = file;
  if (!output_.vtp) return;
  const auto vtp = folder_.vtp(motion_.steps());
  write_vtp(vtp, motion_.picture());
  wrote(vtp);
  pvd_.add(motion_.time(), vtp_entry(motion_.steps()));
}

void RunWriter::write_reference_meshes() {
  const long frame = motion_.steps() * output_.reference_frames;
  if (due(motion_.steps(), output_.rec_every)) {
    write_rec(folder_.rec(frame), motion_.record(), output_.rec_flavour);
    wrote(folder_.rec(frame));
  }
  if (due(motion_.steps(), output_.obj_every)) {
    write_obj(folder_.obj(frame), motion_.frame(), ObjNormals::with);
    wrote(folder_.obj(frame));
  }
}

void RunWriter::wrote(const std::filesystem::path& file) {
  if (saves_checkpoints_) since_checkpoint_.push_back(file);
}

void RunWriter::write_checkpoint() {
  if (!saves_checkpoints_ || motion_.steps() == last_checkpoint_) return;
  const double begin = watch_.seconds();
  nlohmann::json content = nlohmann::json::object();
  motion_.save(content);
  wait_for_what_was_written();
  run::write_checkpoint(folder_.checkpoint(), output_.checkpoint, std::move(content));
  last_checkpoint_ = motion_.steps();
  checkpoint_interval_.written(begin, watch_.seconds());
}

// A run goes on behind its checkpoint: after a power cut, too, the tables and frames until there are needed.
void RunWriter::wait_for_what_was_written() {
  std::set<std::filesystem::path> folders{folder_.path()};
  for (const OpenTable& open : tables_) base::wait_for_disk(folder_.path() / open.table.file);
  if (output_.vtp) base::wait_for_disk(folder_.pvd());
  for (const std::filesystem::path& file : since_checkpoint_) {
    base::wait_for_disk(file);
    folders.insert(file.parent_path());
  }
  for (const std::filesystem::path& folder : folders) base::wait_for_disk(folder);
  since_checkpoint_.clear();
}

void RunWriter::write_json(const std::string& ended, const Outcome& outcome) const {
  write_run_json(folder_.run_json(), output_, motion_, ended, outcome);
}

}  // namespace lostopos::run
