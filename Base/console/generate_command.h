#pragma once

#include <functional>

#include "Base/console/command_line.h"
#include "Base/console/manual_page.h"

namespace base {

/// Adds the hidden command "generate bash|zsh|man", which prints a completion script or the manual page; the build and
/// the installation use it. The command refers to `line`.
void add_generate_command(CommandLine& line, std::function<Manual()> manual);

}  // namespace base
