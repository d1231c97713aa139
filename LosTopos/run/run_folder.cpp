#include "LosTopos/run/run_folder.h"

#include <array>
#include <cstdio>
#include <system_error>

#include "Base/error.h"
#include "Base/io/atomic_file.h"
#include "Base/io/temporary_file.h"
#include "Base/io/write_error.h"

namespace lostopos::run {

namespace fs = std::filesystem;

namespace {

constexpr std::array run_files{"run.json",   "metrics.csv",     "volumes.csv",
                               "events.csv", "checkpoint.cbor", "surface.pvd"};
constexpr std::array run_folders{"frames", "vtp", "rec", "obj", "stats"};

bool holds_a_run(const fs::path& path) {
  for (const char* file : run_files)
    if (fs::exists(path / file)) return true;
  for (const char* folder : run_folders)
    if (fs::exists(path / folder)) return true;
  return false;
}

void remove_run(const fs::path& path) {
  std::error_code ignored;
  for (const char* file : run_files) fs::remove(path / file, ignored);
  for (const char* folder : run_folders) fs::remove_all(path / folder, ignored);
}

fs::path topmost_missing(const fs::path& path) {
  fs::path missing;
  for (fs::path p = fs::absolute(path); !p.empty() && !fs::exists(p) && p != p.parent_path(); p = p.parent_path())
    missing = p;
  return missing;
}

fs::path numbered(const fs::path& folder, const char* what, long step, const char* extension) {
  char name[40];
  std::snprintf(name, sizeof(name), "%s%06ld.%s", what, step, extension);
  return folder / name;
}

// Removes a folder and those that it is in, up to `topmost`, as far as nobody else has put something there.
void remove_empty(const fs::path& path, const fs::path& topmost) {
  if (topmost.empty()) return;
  std::error_code error;
  for (fs::path p = fs::absolute(path); p != p.parent_path(); p = p.parent_path()) {
    fs::remove(p, error);
    if (error || p == topmost) return;
  }
}

// And tries that it can be written to.
void make_frames(const fs::path& path) {
  base::make_folder(path / "frames");
  base::AtomicFile probe(path / "frames" / "probe");
  probe.stream() << "probe\n";
  probe.commit();
  fs::remove(path / "frames" / "probe");
}

}  // namespace

RunFolder::RunFolder(fs::path path, fs::path made) : path_(std::move(path)), made_(std::move(made)), lock_(path_) {
  base::remove_stale_temporaries(path_);
  for (const char* folder : run_folders) base::remove_stale_temporaries(path_ / folder);
}

RunFolder RunFolder::make(const fs::path& path, const fs::path& made) {
  try {
    base::make_folder(path, "give a folder that can be written to with --out");
    return {path, made};
  } catch (const base::FileError&) {
    remove_empty(path, made);
    throw;
  }
}

RunFolder RunFolder::create(const fs::path& path, bool force) {
  if (fs::exists(path) && !fs::is_directory(path))
    throw base::InputError(path.string() + " is a file; the output has to go to a folder");
  RunFolder folder = make(path, topmost_missing(path));
  if (holds_a_run(path)) {
    if (!force)
      throw base::InputError(path.string() + " already holds a run; give another --out, or --force to replace it");
    remove_run(path);
  }
  try {
    make_frames(path);
  } catch (...) {
    folder.discard();
    throw;
  }
  return folder;
}

RunFolder RunFolder::open(const fs::path& path) {
  base::make_folder(path);
  RunFolder folder(path, {});
  make_frames(path);
  return folder;
}

fs::path RunFolder::frame(long step) const {
  return numbered(path_ / "frames", "frame_", step, "ply");
}
fs::path RunFolder::vtp(long step) const {
  return numbered(path_ / "vtp", "frame_", step, "vtp");
}
fs::path RunFolder::rec(long frame) const {
  return numbered(path_ / "rec", "mesh", frame, "rec");
}
fs::path RunFolder::obj(long frame) const {
  return numbered(path_ / "obj", "mesh", frame, "obj");
}

void RunFolder::discard() {
  remove_run(path_);
  lock_.reset();
  remove_empty(path_, made_);
}

}  // namespace lostopos::run
