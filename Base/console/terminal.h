#pragma once

#include <string>
#include <string_view>

namespace base {

/// Columns of the terminal behind a file descriptor, or 80 where it does not say.
int terminal_width(int descriptor);

/// Whether text may be coloured: on a terminal, unless NO_COLOR (https://no-color.org) is set or TERM is dumb.
bool may_colour(int descriptor);

/// Lines on stderr, "PROGRAM: TEXT", red and yellow on a terminal; the middle of a very long text is left out.
void print_error(std::string_view program, std::string_view text);
void print_warning(std::string_view program, std::string_view text);

}  // namespace base
