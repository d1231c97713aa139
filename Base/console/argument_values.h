#pragma once

#include <span>
#include <string>
#include <vector>

#include "Base/console/command.h"

namespace base {

/// Puts what was written on the command line into the argument's target; `words` is empty for a flag. Throws InputError
/// when a word is not of the target's kind, or one too many is given.
void assign(const Argument& argument, std::span<const std::string> words);

/// What the argument holds before the command line is read, as a user would write it; empty: nothing.
std::string default_text(const Argument& argument);

/// "N", "X", "WORD", … : what stands for a value in help texts; empty for a flag.
std::string placeholder(const Argument& argument);

}  // namespace base
