#pragma once

#include <map>
#include <string>
#include <string_view>

#include "Base/options/option_spec.h"

namespace base {

/// The options of one scene: a value for every spec, and which of them somebody set.
///
/// Keys are checked against the specs and values against what the specs allow at the moment they are set; every error
/// is a InputError of one line that begins with `where` (a file and line, or "--set") and says what would be
/// right.
class OptionSet {
 public:
  /// `listed_by`: a command that prints the options, for the message about a key that is not known. `elsewhere`:
  /// options that this set does not have but another one does, so that their owner can be named.
  explicit OptionSet(std::vector<OptionSpec> specs, std::string listed_by = {}, std::vector<OptionSpec> elsewhere = {});

  /// Sets an option from text as on the command line. "key+=word" text is handled by `append`.
  void set_text(std::string_view key, std::string_view text, std::string_view where);
  void set(std::string_view key, const OptionValue& value, std::string_view where);
  /// Adds words to an option that holds a list, leaving out those it has.
  void append(std::string_view key, std::string_view words, std::string_view where);
  /// Replaces a default: `is_set` stays false.
  void set_default(std::string_view key, const OptionValue& value);
  /// As if it had never been set; its value is the specification's default.
  void unset(std::string_view key);
  /// Reads "key=value" or "key+=word" as after --set.
  void set_assignment(std::string_view assignment, std::string_view where);

  double number(std::string_view key) const { return std::get<double>(value(key)); }
  long whole(std::string_view key) const { return std::get<long>(value(key)); }
  bool flag(std::string_view key) const { return std::get<bool>(value(key)); }
  const std::string& word(std::string_view key) const { return std::get<std::string>(value(key)); }
  const std::vector<std::string>& words(std::string_view key) const { return std::get<Words>(value(key)); }
  const OptionValue& value(std::string_view key) const;
  bool is_set(std::string_view key) const;
  bool has(std::string_view key) const;
  const std::vector<OptionSpec>& specs() const { return specs_; }

 private:
  struct Entry {
    OptionValue value;
    bool set = false;
  };
  std::size_t place_of(std::string_view key, std::string_view where) const;

  std::vector<OptionSpec> specs_, elsewhere_;
  std::vector<Entry> entries_;
  std::string listed_by_;
};

}  // namespace base
