#include "Base/console/program.h"

#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <new>

#include "Base/console/interrupt_guard.h"
#include "Base/console/terminal.h"
#include "Base/error.h"
#include "Base/interruption.h"

namespace base {
namespace {

int run_and_report(CommandLine& line, int argc, const char* const* argv,
                   const std::function<void(CommandLine&)>& add_commands) {
  const std::string& name = line.name();
  try {
    add_commands(line);
    return line.run(argc, argv);
  } catch (const DiskError& error) {
    print_error(name, error.what());
    return exit_disk_full;
  } catch (const Interrupted& stopped) {
    print_error(name, stopped.what());
    return InterruptGuard::exit_code();
  } catch (const InputError& error) {
    print_error(name, error.what());
    return exit_bad_input;
  } catch (const std::bad_alloc&) {
    print_error(name, "out of memory: the mesh is too large for this machine");
    return exit_cannot_go_on;
  } catch (const std::exception& error) {
    print_error(name, error.what());
    return exit_cannot_go_on;
  }
}

}  // namespace

std::string program_name(int argc, const char* const* argv, const std::string& otherwise) {
  if (argc < 1 || argv[0] == nullptr) return otherwise;
  const std::string path = argv[0];
  const std::string name = path.substr(path.rfind('/') + 1);  // npos + 1 == 0
  return name.empty() ? otherwise : name;
}

std::string command_text(const std::string& name, int argc, const char* const* argv) {
  std::string text = name;
  for (int i = 1; i < argc; ++i) text += std::string(" ") + argv[i];
  return text;
}

int run_command_line(CommandLine& line, int argc, const char* const* argv,
                     const std::function<void(CommandLine&)>& add_commands) {
  // A file that grows past its limit is reported by the failing write, not by the end of the program.
  std::signal(SIGXFSZ, SIG_IGN);
  const int code = run_and_report(line, argc, argv, add_commands);
  const bool failed_before = std::ferror(stdout) != 0;
  errno = 0;
  if ((std::fflush(stdout) == 0 && !failed_before) || code != exit_done) return code;
  print_error(line.name(),
              std::string("cannot write the output: ") + (errno != 0 ? std::strerror(errno) : "write error"));
  return exit_disk_full;
}

}  // namespace base
