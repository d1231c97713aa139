#pragma once

#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "Base/options/option_set.h"

namespace lostopos {

/// How a key of the reference programs' option files is taken.
enum class KeyUse {
  as_it_is,   ///< its value is that of our option
  converted,  ///< it sets one or several of our options, by other values
  without,    ///< there is nothing here that it could set
};

/// A key of the reference programs' option files, and what it means here: the table of docs/reference-options.md.
struct ReferenceKey {
  std::string_view name;
  std::string_view absent;  ///< the value that a file means which does not name it; empty: as the scene has it
  KeyUse use;
  std::string_view ours;     ///< our options; empty: none
  std::string_view meaning;  ///< how its value becomes ours, or why it has no meaning; empty: it is the same
};

/// The keys that both programs have for remeshing and topology; absent values: those of soap films, or of plain
/// tracking.
std::vector<ReferenceKey> tracker_reference_keys(bool plain_tracking);

/// The rows of the table, in Markdown.
std::string reference_key_rows(std::span<const ReferenceKey> keys);

/// The values of an option file: one `key value` a line, # comments; of a key that is named twice the last counts.
class ReferenceValues {
 public:
  /// Throws base::FileError when the file cannot be read, base::InputError with file and line for what is not a key and
  /// one value, or a key that is not among these (which have to live on).
  ReferenceValues(const std::string& file, std::span<const ReferenceKey> keys);

  /// Whether the file names the key.
  bool given(std::string_view key) const { return given_.contains(key); }
  /// The value, of the file or for want of one there; throws base::InputError with its place when it is none.
  /// @{
  const std::string& text(std::string_view key) const;
  double number(std::string_view key) const;
  long whole(std::string_view key) const;
  bool flag(std::string_view key) const;
  /// @}
  /// File and line, or the file.
  const std::string& where(std::string_view key) const;
  std::span<const ReferenceKey> keys() const { return keys_; }

  /// Sets an option of ours: as a default where the file does not name the key.
  void set(std::string_view key, std::string_view ours, const base::OptionValue& value, base::OptionSet& options) const;
  /// The same with the key's own text.
  void set_as_it_is(std::string_view key, std::string_view ours, base::OptionSet& options) const;

 private:
  struct Line {
    std::string value, where;
  };
  base::OptionValue parsed(std::string_view key, const base::OptionValue& like) const;

  std::string file_;
  std::span<const ReferenceKey> keys_;
  std::map<std::string, Line, std::less<>> given_, absent_;
};

/// Sets the options of remeshing and topology; returns what there is to know of values that mean nothing here.
std::vector<std::string> set_tracker_options(const ReferenceValues& values, base::OptionSet& options);

}  // namespace lostopos
