#include "Base/console/terminal.h"

#include <sys/ioctl.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>

namespace base {
namespace {

// `colour`: an SGR number.
void print_line(std::string_view program, std::string_view text, int colour) {
  std::string line = std::string(program) + ": " + std::string(text);
  if (may_colour(STDERR_FILENO)) line = "\033[" + std::to_string(colour) + "m" + line + "\033[0m";
  std::fprintf(stderr, "%s\n", line.c_str());
}

}  // namespace

int terminal_width(int descriptor) {
  winsize size{};
  constexpr int usual = 80;
  return ioctl(descriptor, TIOCGWINSZ, &size) == 0 && size.ws_col > 0 ? size.ws_col : usual;
}

bool may_colour(int descriptor) {
  const char *no_color = std::getenv("NO_COLOR"), *term = std::getenv("TERM");
  const bool refused =
      (no_color != nullptr && *no_color != '\0') || (term != nullptr && std::string_view(term) == "dumb");
  return !refused && isatty(descriptor) != 0;
}

void print_error(std::string_view program, std::string_view text) {
  print_line(program, text, 31);
}

void print_warning(std::string_view program, std::string_view text) {
  print_line(program, text, 33);
}

}  // namespace base
