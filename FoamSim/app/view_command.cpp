#include <cstdio>
#include <memory>

#include "Base/error.h"
#include "FoamSim/app/commands.h"
#include "FoamSim/app/common_arguments.h"
#include "FoamSim/app/session.h"
#include "FoamSim/app/web_arguments.h"
#include "FoamSim/web/server/run_pages.h"
#include "FoamSim/web/server/server.h"
#include "FoamSim/web/viewer_page.h"

namespace foamsim::app {
namespace {

struct ViewArguments {
  std::string run, precision = "quantised";
  std::vector<std::string> fields;
  long port = 0;
};

int view_run(const ViewArguments& arguments) {
  constexpr long largest_port = 65535;
  if (arguments.port < 0 || arguments.port > largest_port)
    throw base::InputError("--port has to be a whole number from 0 (one that is free) to 65535");
  web::RunPages pages(arguments.run, web::require_viewer_page(), {arguments.fields, precision_of(arguments.precision)});
  web::Server server({static_cast<unsigned short>(arguments.port)},
                     [&pages](const std::string& path) { return pages.answer(path); });
  const InterruptGuard guard;
  std::printf("%s\nopen this address in a browser on this machine; Ctrl-C ends it\n", server.address().c_str());
  std::fflush(stdout);
  server.run([] { return InterruptGuard::interrupted(); });
  return InterruptGuard::exit_code();
}

}  // namespace

void add_view_command(base::Command& root, const Program&) {
  base::Command& command =
      root.add_command("view", "serve a run to a browser on this machine, also while it goes on, until Ctrl-C");
  auto a = std::make_shared<ViewArguments>();
  add_run_folder(command, a->run);
  command.add({.name = "--port", .target = &a->port, .help = "port of 127.0.0.1; 0: one that is free"});
  add_frame_options(command, a->fields, a->precision);
  command.set_action([a] { return view_run(*a); });
}

}  // namespace foamsim::app
