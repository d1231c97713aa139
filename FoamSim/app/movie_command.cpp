#include <unistd.h>

#include <cerrno>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <memory>

#include "Base/error.h"
#include "Base/interruption.h"
#include "Base/io/write_error.h"
#include "FoamSim/app/commands.h"
#include "FoamSim/app/common_arguments.h"
#include "FoamSim/app/film_encoder.h"
#include "FoamSim/app/look.h"
#include "FoamSim/app/session.h"
#include "FoamSim/render/png.h"
#include "LosTopos/run/run_frames.h"

namespace foamsim::app {

namespace fs = std::filesystem;

namespace {

struct MovieArguments {
  std::string run, film, codec;
  double fps = 25, turn = 0;
  LookArguments look;
  int threads = 0;
  bool quiet = false;
};

// A folder for the pictures that goes with them.
class ScratchPictures {
 public:
  ScratchPictures() {
    std::string name = (fs::temp_directory_path() / "foamsim-movie-XXXXXX").string();
    if (mkdtemp(name.data()) == nullptr) base::throw_write_error("cannot make a folder " + name, errno);
    folder_ = name;
  }
  ScratchPictures(const ScratchPictures&) = delete;
  ScratchPictures& operator=(const ScratchPictures&) = delete;
  ~ScratchPictures() {
    std::error_code ignored;
    fs::remove_all(folder_, ignored);
  }
  const fs::path& folder() const { return folder_; }
  fs::path picture(std::size_t number) const {
    char name[24];
    std::snprintf(name, sizeof(name), "%06zu.png", number);
    return folder_ / name;
  }

 private:
  fs::path folder_;
};

Look look_of(const MovieArguments& arguments) {
  Look look = arguments.look.look();
  if (look.options.background == render::Background::transparent)
    throw base::InputError("--background transparent: films have a background; dark or white");
  if (!std::isfinite(arguments.turn)) throw base::InputError("--turn has to be a finite number of degrees");
  return look;
}

void make_movie(const MovieArguments& arguments) {
  const Look look = look_of(arguments);
  std::vector<fs::path> frames;
  for (const lostopos::run::RunFrame& frame : lostopos::run::run_frames(arguments.run)) frames.push_back(frame.file);
  const FilmEncoder encoder(arguments.film, arguments.codec, arguments.fps, look.options.width, look.options.height);
  const ThreadLimit limit = thread_limit(arguments.threads);
  const InterruptGuard guard;
  Progress progress("movie", arguments.quiet);
  progress.show("looking at " + std::to_string(frames.size()) + " frames", 0);
  const Painter painter(look, frames, arguments.turn != 0);
  const ScratchPictures pictures;
  const auto count = static_cast<double>(frames.size());
  for (std::size_t i = 0; i < frames.size(); ++i) {
    if (InterruptGuard::interrupted()) throw base::Interrupted("interrupted; no film was written");
    const double degrees = frames.size() > 1 ? arguments.turn * static_cast<double>(i) / (count - 1) : 0;
    render::write_png(painter.draw(frames[i], degrees), pictures.picture(i));
    progress.show("picture " + std::to_string(i + 1) + " of " + std::to_string(frames.size()),
                  static_cast<double>(i + 1) / count);
  }
  encoder.encode(pictures.folder(), [] { return InterruptGuard::interrupted(); });
  progress.clear();
  if (!arguments.quiet) std::printf("%s\n", arguments.film.c_str());
}

}  // namespace

void add_movie_command(base::Command& root, const Program&) {
  using base::Argument;
  base::Command& command = root.add_command("movie", "a film of a run's frames, made by ffmpeg");
  auto a = std::make_shared<MovieArguments>();
  command.add({.name = "run",
               .target = &a->run,
               .help = "the run's folder",
               .required = true,
               .offers = Argument::Offers::folders});
  command.add({.name = "film",
               .target = &a->film,
               .help = "file to write: .mp4, .mov, .mkv, .webm or .gif",
               .required = true,
               .offers = Argument::Offers::files});
  command.add({.name = "--fps", .target = &a->fps, .help = "frames a second"});
  command.add({.name = "--codec", .target = &a->codec, .help = "encoder of ffmpeg; by default one for the ending"});
  command.add(
      {.name = "--turn", .target = &a->turn, .help = "degrees by which the camera goes round from first to last"});
  a->look.add_to(command);
  add_threads(command, a->threads);
  add_quiet(command, a->quiet);
  command.set_action([a] {
    make_movie(*a);
    return exit_done;
  });
}

}  // namespace foamsim::app
