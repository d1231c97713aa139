#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace base {

/// The words of a text, which are separated by blanks.
std::vector<std::string> words_of(std::string_view text);
/// Words in one text again.
std::string joined(std::span<const std::string> words, std::string_view between = " ");

}  // namespace base
