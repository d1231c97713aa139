#include "Base/console/terminal.h"

#include <sys/ioctl.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>

namespace base {
namespace {

// A message may quote a word of a file, which may be as long as the file.
std::string shortened(std::string_view text) {
  constexpr std::size_t longest = 4000, kept_at_the_end = 1000;
  if (text.size() <= longest) return std::string(text);
  const auto begins_a_letter = [&](std::size_t i) { return (static_cast<unsigned char>(text[i]) & 0xc0U) != 0x80U; };
  std::size_t end_of_head = longest - kept_at_the_end, tail = text.size() - kept_at_the_end;
  for (int i = 0; i < 3 && !begins_a_letter(end_of_head); ++i) --end_of_head;  // of up to four bytes, in UTF-8
  for (int i = 0; i < 3 && !begins_a_letter(tail); ++i) ++tail;
  return std::string(text.substr(0, end_of_head)) + " … " + std::string(text.substr(tail));
}

// `colour`: an SGR number.
void print_line(std::string_view program, std::string_view text, int colour) {
  std::string line = std::string(program) + ": " + shortened(text);
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
