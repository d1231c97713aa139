#pragma once

#include <string>
#include <utility>
#include <vector>

#include "Base/console/command_line.h"

namespace base {

/// What a manual page says besides what the commands take.
struct Manual {
  struct Section {
    std::string title;
    std::vector<std::pair<std::string, std::string>> entries;  ///< term, what it is
  };
  std::string description;  ///< paragraphs, separated by empty lines
  std::vector<Section> sections;
};

/// The manual page of a program, section 1, in the man macros of troff.
std::string manual_page(const CommandLine& line, const Manual& manual);

/// Entries for option keys: "KEY (default VALUE)" and the summary.
std::vector<std::pair<std::string, std::string>> manual_entries(const std::vector<OptionSpec>& specs);

}  // namespace base
