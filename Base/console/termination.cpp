#include "Base/console/termination.h"

#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <new>

#include "Base/exit_code.h"

namespace base {
namespace {

// Without memory: there may be none.
void print(const char* text) {
  if (::write(STDERR_FILENO, text, std::strlen(text)) < 0) errno = 0;
}

[[noreturn]] void report_and_end() {
  print(program_invocation_short_name);
  print(": ");
  try {
    if (const std::exception_ptr active = std::current_exception()) std::rethrow_exception(active);
    print("ended by an internal error");
  } catch (const std::bad_alloc&) {
    print("out of memory");
  } catch (const std::exception& error) {
    print("ended by an internal error: ");
    print(error.what());
  } catch (...) {
    print("ended by an internal error");
  }
  print("; files are as after a kill, and a run goes on from its last checkpoint with --resume\n");
  std::_Exit(exit_cannot_go_on);
}

}  // namespace

void report_terminations() {
  std::set_terminate(report_and_end);
}

}  // namespace base
