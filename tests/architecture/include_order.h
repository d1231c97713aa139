#pragma once

#include <istream>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace architecture {

/// Which part of the source tree may include which. Written as lines
///   place: places that it stands on
/// where a place is a folder or a file. What a place stands on has to be written above it, as itself or as a folder
/// that it is in, so that no order with a circle can be written down. A source may include what is in its own place and
/// in all that this stands on, also by way of others.
class IncludeOrder {
 public:
  /// Throws std::runtime_error, with the line, for a place that is named twice or that stands on one not yet named.
  static IncludeOrder read(std::istream& lines);

  /// The place that a file is in: the longest that fits, empty where none does.
  std::string_view place_of(std::string_view file) const;
  /// Why `source` must not include `included` (both as paths in the tree), or nothing where it may.
  std::optional<std::string> objection(std::string_view source, std::string_view included) const;

  const std::vector<std::string>& places() const { return places_; }

 private:
  std::size_t index_of(std::string_view file) const;

  std::vector<std::string> places_;
  std::vector<std::vector<bool>> sees_;  // of each place: the ones that it stands on, itself included
};

/// The names that the #include "..." lines of a source give.
std::vector<std::string> quoted_includes(std::istream& source);

/// The lines between "```order" and "```" of a page. Throws std::runtime_error where there are none.
std::string fenced_order(std::istream& page);

}  // namespace architecture
