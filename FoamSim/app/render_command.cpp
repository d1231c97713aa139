#include <cstdio>
#include <memory>
#include <set>

#include "Base/error.h"
#include "Base/io/write_error.h"
#include "FoamSim/app/commands.h"
#include "FoamSim/app/common_arguments.h"
#include "FoamSim/app/look.h"
#include "FoamSim/app/session.h"
#include "FoamSim/render/png.h"

namespace foamsim::app {

namespace fs = std::filesystem;

namespace {

struct RenderArguments {
  std::vector<std::string> frames;
  std::string out;
  LookArguments look;
  int turntable = 1, threads = 0;
};

// A picture to make: of which frame, from how far round.
struct Shot {
  fs::path frame, file;
  double degrees = 0;
};

std::vector<Shot> shots_of(const RenderArguments& arguments) {
  constexpr int most = 100'000;
  const int sides = arguments.turntable;
  if (sides < 1 || sides > most)
    throw base::InputError("--turntable has to be a whole number from 1 to " + std::to_string(most));
  std::vector<Shot> shots;
  std::set<fs::path> taken;
  for (const std::string& frame : arguments.frames)
    for (int side = 0; side < sides; ++side) {
      char number[16] = "";
      if (sides > 1) std::snprintf(number, sizeof(number), "_%03d", side);
      const std::string name = fs::path(frame).stem().string() + number + ".png";
      shots.push_back({frame, fs::path(arguments.out) / name, 360.0 * side / sides});
      if (!taken.insert(shots.back().file).second)
        throw base::InputError("two frames would both become " + shots.back().file.string() +
                               "; draw them into different folders");
    }
  return shots;
}

void draw(const RenderArguments& arguments) {
  const Look look = arguments.look.look();
  const std::vector<Shot> shots = shots_of(arguments);
  const std::vector<fs::path> frames(arguments.frames.begin(), arguments.frames.end());
  const ThreadLimit limit = thread_limit(arguments.threads);
  const Painter painter(look, frames, arguments.turntable > 1);
  base::make_folder(arguments.out);
  for (const Shot& shot : shots) {
    render::write_png(painter.draw(shot.frame, shot.degrees), shot.file);
    std::printf("%s\n", shot.file.c_str());
  }
}

}  // namespace

void add_render_command(base::Command& root, const Program&) {
  using base::Argument;
  base::Command& command = root.add_command("render", "draw frames as pictures, all with the same camera");
  auto a = std::make_shared<RenderArguments>();
  command.add({.name = "frames",
               .target = &a->frames,
               .help = "mesh files",
               .required = true,
               .list = Argument::List::words,
               .offers = Argument::Offers::files});
  command.add({.name = "--out",
               .target = &a->out,
               .help = "folder for the pictures",
               .required = true,
               .offers = Argument::Offers::folders});
  a->look.add_to(command);
  command.add({.name = "--turntable", .target = &a->turntable, .help = "so many pictures of each frame, all around"});
  add_threads(command, a->threads);
  command.set_action([a] {
    draw(*a);
    return exit_done;
  });
}

}  // namespace foamsim::app
