#include <cstdio>
#include <memory>

#include "Base/console/terminal.h"
#include "Base/error.h"
#include "Base/interruption.h"
#include "FoamSim/app/commands.h"
#include "FoamSim/app/common_arguments.h"
#include "FoamSim/app/session.h"
#include "FoamSim/app/web_arguments.h"
#include "FoamSim/web/export_web.h"
#include "FoamSim/web/viewer_page.h"

namespace foamsim::app {
namespace {

constexpr std::uintmax_t large = 50'000'000;

struct ExportArguments {
  std::string run, out, precision = "quantised";
  std::vector<std::string> fields;
  long every = 1;
  bool force = false, quiet = false;
};

std::string in_megabytes(std::uintmax_t bytes) {
  char text[40];
  std::snprintf(text, sizeof(text), "%.1f MB", static_cast<double>(bytes) / 1e6);
  return text;
}

int export_run(const ExportArguments& arguments, const Program& program) {
  if (arguments.every < 1) throw base::InputError("--every has to be a whole number >= 1");
  const std::string_view page = web::require_viewer_page();
  const std::filesystem::path out(arguments.out);
  if (std::filesystem::exists(out) && !arguments.force)
    throw base::InputError("'" + arguments.out + "' is there already; replace it with --force");
  const InterruptGuard guard;
  Progress progress("export-web", arguments.quiet);
  web::ExportHooks hooks;
  hooks.interrupted = [] { return InterruptGuard::interrupted(); };
  hooks.begin = [&](std::uintmax_t bytes, std::size_t frames) {
    if (bytes > large)
      base::print_warning(program.name, "about " + in_megabytes(bytes) + " for " + std::to_string(frames) +
                                            " frames; --every N takes fewer, --fields none leaves the fields out");
  };
  hooks.frame_done = [&](std::size_t done, std::size_t of) {
    progress.show("frame " + std::to_string(done) + " of " + std::to_string(of),
                  static_cast<double>(done) / static_cast<double>(of));
  };
  try {
    const web::ExportOutcome outcome = web::export_web(
        arguments.run, out, page, {{arguments.fields, precision_of(arguments.precision)}, arguments.every}, hooks);
    progress.clear();
    if (!arguments.quiet)
      std::printf("%s: %zu frames, %s\n", out.c_str(), outcome.frames, in_megabytes(outcome.bytes).c_str());
  } catch (const base::Interrupted&) {
    return InterruptGuard::exit_code();
  }
  return exit_done;
}

}  // namespace

void add_export_web_command(base::Command& root, const Program& program) {
  base::Command& command = root.add_command("export-web", "write a run as one file that shows it in any browser");
  auto a = std::make_shared<ExportArguments>();
  add_run_folder(command, a->run);
  command.add({.name = "out",
               .target = &a->out,
               .help = "file to write, OUT.html",
               .required = true,
               .offers = base::Argument::Offers::files});
  command.add({.name = "--every", .target = &a->every, .help = "of the run's frames take each N-th, and the last one"});
  add_frame_options(command, a->fields, a->precision);
  command.add({.name = "--force", .target = &a->force, .help = "replace the file"});
  add_quiet(command, a->quiet);
  command.set_action([a, &program] { return export_run(*a, program); });
}

}  // namespace foamsim::app
