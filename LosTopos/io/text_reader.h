#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

namespace lostopos {

/// Cuts the next word off the front of `rest`; empty when only white space is left. Words end at white space.
std::string_view take_word(std::string_view& rest);

/// Words, numbers and lines of a text that is held in memory. What the text does wrong is an InputError that names the
/// file and the line.
class TextReader {
 public:
  /// `name`: the file's, for messages; `first_line`: the number of the first line of `text` in the file.
  TextReader(std::string text, std::string name, std::size_t first_line = 1);
  TextReader(const TextReader&) = delete;
  TextReader& operator=(const TextReader&) = delete;
  /// Reads the whole file; FileError when that fails.
  static TextReader of_file(const std::filesystem::path& path);

  /// Goes on to the next line (the first one, to begin with); false at the end.
  bool next_line();
  /// What is left of the present line.
  std::string_view line() const { return line_; }
  /// The next word, on this or a later line; empty at the end.
  std::string_view next_word();
  /// The next word as a number; `what` says what it stands for, in messages.
  double number(const char* what);
  std::int64_t integer(const char* what);

  std::uint64_t remaining() const { return line_.size() + (text_.size() - next_); }
  /// Throws InputError unless `count` records of `words_each` words can stand in the rest of the text: a word takes at
  /// least a character and the space before it.
  void require_records(std::uint64_t count, std::uint64_t words_each, std::string_view what) const;
  /// Number of the present line in the file, from 1.
  std::size_t line_number() const { return line_number_; }
  /// File and line, for messages.
  std::string place() const { return name_ + ", line " + std::to_string(line_number_); }
  [[noreturn]] void fail(const std::string& problem) const;

 private:
  std::string_view required_word(const char* what);

  std::string text_;
  std::string name_;
  std::string_view line_;
  std::size_t next_ = 0;  // start of the line after the present one
  std::size_t line_number_;
  bool started_ = false;
};

}  // namespace lostopos
