#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace lostopos {

/// Lines and words of a datafile of Surface Evolver, held in memory: a backslash goes on with the next line, comments
/// are those of C++, and commas, colons, semicolons and equals signs separate words as blanks do. What the text does
/// wrong is an InputError that names the file and the line.
class FeText {
 public:
  /// `name`: the file's, for messages.
  FeText(std::string text, std::string name);
  FeText(const FeText&) = delete;
  FeText& operator=(const FeText&) = delete;

  /// Goes on to the next line that has a word (the first one, to begin with); false at the end.
  bool next_line();
  /// The next word of the line; empty at its end. Text in double quotes is one word.
  std::string_view next_word();
  /// The next word as a number; `what` says what it stands for, in messages.
  double number(const char* what);
  std::int64_t integer(const char* what);

  /// Of the present line in the file, from 1.
  std::size_t line_number() const { return line_number_; }
  [[noreturn]] void fail(const std::string& problem) const;

 private:
  bool skip_comment();
  void skip_blanks();
  bool at(std::string_view what) const { return std::string_view(text_).substr(next_, what.size()) == what; }
  std::size_t bytes_of_continuation() const;
  std::size_t word_end() const;

  std::string text_;
  std::string name_;
  std::size_t next_ = 0;
  std::size_t line_number_ = 1;
  bool started_ = false;
};

/// The word in small letters, as keywords are compared; cut short where it is longer than any.
std::string small_letters(std::string_view word);

}  // namespace lostopos
