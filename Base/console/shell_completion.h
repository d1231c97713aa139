#pragma once

#include <string>

#include "Base/console/command_line.h"

namespace base {

/// A script that completes the program's commands, options, their words and the keys of key=value words in bash, to be
/// put where bash-completion looks (share/bash-completion/completions/NAME).
std::string bash_completion(const CommandLine& line);

/// The same for zsh (share/zsh/site-functions/_NAME).
std::string zsh_completion(const CommandLine& line);

}  // namespace base
