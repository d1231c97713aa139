#include "LosTopos/io/fe_text.h"

#include <algorithm>
#include <cctype>

#include "Base/io/number_text.h"
#include "LosTopos/io/read_error.h"

namespace lostopos {
namespace {

constexpr std::string_view fe_blanks = " \t\r\v\f,:;=";

}  // namespace

FeText::FeText(std::string text, std::string name) : text_(std::move(text)), name_(std::move(name)) {}

bool FeText::next_line() {
  if (started_)
    while (!next_word().empty()) {  // ends: every word is a part of the line
    }
  started_ = true;
  for (skip_blanks(); next_ < text_.size(); skip_blanks()) {
    if (text_[next_] != '\n') return true;
    ++next_;
    ++line_number_;
  }
  return false;
}

std::string_view FeText::next_word() {
  skip_blanks();
  const std::size_t begin = next_;
  next_ = word_end();
  return std::string_view(text_).substr(begin, next_ - begin);
}

double FeText::number(const char* what) {
  const std::string_view word = next_word();
  const auto value = base::parse_double(word);
  if (!value) fail(in_quotes(word) + " stands where " + what + " should; a number, not an expression, would be right");
  return *value;
}

std::int64_t FeText::integer(const char* what) {
  const std::string_view word = next_word();
  const auto value = base::parse_integer(word);
  if (!value) fail(in_quotes(word) + " stands where " + what + " should; a whole number would be right");
  return *value;
}

void FeText::fail(const std::string& problem) const {
  throw_at_line(name_, line_number_, problem);
}

// A comment over several lines does not end a line.
bool FeText::skip_comment() {
  if (at("//")) {
    next_ = std::min(text_.find('\n', next_), text_.size());
    return true;
  }
  if (!at("/*")) return false;
  const std::size_t end = text_.find("*/", next_ + 2);
  if (end == std::string::npos) fail("the comment that begins here has no end");
  line_number_ += static_cast<std::size_t>(std::count(text_.data() + next_, text_.data() + end, '\n'));
  next_ = end + 2;
  return true;
}

void FeText::skip_blanks() {
  while (next_ < text_.size()) {  // ends: what is not passed over leaves
    if (fe_blanks.find(text_[next_]) != std::string_view::npos) {
      ++next_;
    } else if (const std::size_t bytes = bytes_of_continuation()) {
      next_ += bytes;
      ++line_number_;
    } else if (!skip_comment()) {
      return;
    }
  }
}

std::size_t FeText::bytes_of_continuation() const {
  return at("\\\n") ? 2 : at("\\\r\n") ? 3 : 0;
}

std::size_t FeText::word_end() const {
  const std::string_view text = text_;
  if (at("\"")) {
    const std::size_t end = text.find_first_of("\"\n", next_ + 1);
    if (end == std::string_view::npos || text[end] == '\n') fail("the text that begins with \" has no end");
    return end + 1;
  }
  std::size_t end = next_;
  while (end < text.size() && text[end] != '\n' && text[end] != '\\' &&
         fe_blanks.find(text[end]) == std::string_view::npos) {
    const std::string_view two = text.substr(end, 2);
    if (two == "//" || two == "/*") break;
    ++end;
  }
  return end == next_ && end < text.size() && text[end] == '\\' ? end + 1 : end;
}

std::string small_letters(std::string_view word) {
  constexpr std::size_t longest_keyword = 40;
  std::string small(word.substr(0, longest_keyword + 1));
  std::ranges::transform(small, small.begin(), [](unsigned char c) { return std::tolower(c); });
  return small;
}

}  // namespace lostopos
