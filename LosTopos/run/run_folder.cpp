#include "LosTopos/run/run_folder.h"

#include <array>
#include <cstdio>
#include <system_error>

#include "Base/error.h"
#include "Base/io/atomic_file.h"

namespace lostopos::run {

namespace fs = std::filesystem;

namespace {

constexpr std::array run_files{"run.json",   "metrics.csv",     "volumes.csv",
                               "events.csv", "checkpoint.cbor", "surface.pvd"};
constexpr std::array run_folders{"frames", "vtp", "rec", "obj"};

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

void require_writable(const fs::path& path) {
  base::AtomicFile probe(path / "frames" / "probe");
  probe.stream() << "probe\n";
  probe.commit();
  fs::remove(path / "frames" / "probe");
}

}  // namespace

RunFolder RunFolder::create(const fs::path& path, bool force) {
  if (fs::exists(path) && !fs::is_directory(path))
    throw base::InputError(path.string() + " is a file; the output has to go to a folder");
  if (holds_a_run(path)) {
    if (!force)
      throw base::InputError(path.string() + " already holds a run; give another --out, or --force to replace it");
    remove_run(path);
  }
  const fs::path made = topmost_missing(path);
  std::error_code error;
  fs::create_directories(path / "frames", error);
  RunFolder folder(path, made);
  if (error) {
    folder.discard();
    throw base::FileError("cannot make the output folder " + path.string() + ": " + error.message() +
                          "; give a folder that can be written to with --out");
  }
  try {
    require_writable(path);
  } catch (...) {
    folder.discard();
    throw;
  }
  return folder;
}

RunFolder RunFolder::open(const fs::path& path) {
  std::error_code error;
  fs::create_directories(path / "frames", error);
  if (error) throw base::FileError("cannot write to " + path.string() + ": " + error.message());
  require_writable(path);
  return {path, {}};
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

void RunFolder::discard() const {
  std::error_code ignored;
  if (!made_.empty())
    fs::remove_all(made_, ignored);
  else
    remove_run(path_);
}

}  // namespace lostopos::run
