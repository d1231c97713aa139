#include "LosTopos/io/text_reader.h"

#include <algorithm>

#include "Base/io/number_text.h"
#include "LosTopos/io/byte_reader.h"
#include "LosTopos/io/read_error.h"

namespace lostopos {

std::string_view take_word(std::string_view& rest) {
  constexpr std::string_view space = " \t\r\n\v\f";
  rest.remove_prefix(std::min(rest.find_first_not_of(space), rest.size()));
  const std::string_view word = rest.substr(0, rest.find_first_of(space));
  rest.remove_prefix(word.size());
  return word;
}

TextReader::TextReader(std::string text, std::string name, std::size_t first_line)
    : text_(std::move(text)), name_(std::move(name)), line_number_(first_line) {}

TextReader TextReader::of_file(const std::filesystem::path& path) {
  ByteReader bytes(path);
  return TextReader(bytes.read_text(), bytes.name());
}

bool TextReader::next_line() {
  if (next_ >= text_.size()) {
    line_ = {};
    return false;
  }
  if (started_) ++line_number_;
  started_ = true;
  const std::size_t end = std::min(text_.find('\n', next_), text_.size());
  line_ = std::string_view(text_).substr(next_, end - next_);
  next_ = std::min(end + 1, text_.size());
  return true;
}

std::string_view TextReader::next_word() {
  std::string_view word = take_word(line_);
  while (word.empty() && next_line()) word = take_word(line_);
  return word;
}

std::string_view TextReader::required_word(const char* what) {
  const std::string_view word = next_word();
  if (word.empty()) fail(std::string("the file ends where ") + what + " should follow");
  return word;
}

double TextReader::number(const char* what) {
  const std::string_view word = required_word(what);
  const auto value = base::parse_double(word);
  if (!value) fail(in_quotes(word) + " stands where " + what + " should; a number such as -1.25e-3 would be right");
  return *value;
}

std::int64_t TextReader::integer(const char* what) {
  const std::string_view word = required_word(what);
  const auto value = base::parse_integer(word);
  if (!value) fail(in_quotes(word) + " stands where " + what + " should; a whole number would be right");
  return *value;
}

void TextReader::require_records(std::uint64_t count, std::uint64_t words_each, std::string_view what) const {
  if (words_each == 0 || count <= (remaining() + 1) / 2 / words_each) return;
  fail(std::to_string(count) + " " + std::string(what) + " of " + std::to_string(words_each) +
       " words each should follow, but the file ends after " + std::to_string(remaining()) +
       " characters; it is cut short or its counts are wrong");
}

void TextReader::fail(const std::string& problem) const {
  throw_at_line(name_, line_number_, problem);
}

}  // namespace lostopos
