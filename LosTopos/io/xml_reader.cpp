#include "LosTopos/io/xml_reader.h"

#include <algorithm>
#include <array>
#include <utility>

#include "Base/error.h"
#include "LosTopos/io/read_error.h"

namespace lostopos {
namespace {

constexpr std::string_view space = " \t\r\n";
constexpr std::array<std::pair<char, std::string_view>, 5> entities{
    {{'&', "&amp;"}, {'<', "&lt;"}, {'>', "&gt;"}, {'"', "&quot;"}, {'\'', "&apos;"}}};

}  // namespace

XmlReader::XmlReader(std::string_view text, std::string name) : text_(text), name_(std::move(name)) {
  if (text_.starts_with("\xef\xbb\xbf")) next_ = 3;  // byte-order mark
}

XmlReader::Event XmlReader::next() {
  line_of_tag_at_ = line();
  tag_at_ = next_;
  if (std::exchange(self_closed_, false)) return Event::End;
  for (;;) {  // ends: every turn passes a tag, or leaves
    const std::string_view between = text();
    if (open_.empty() && between.find_first_not_of(space) != std::string_view::npos) {
      skip_space();
      fail("text stands outside of the XML's root element; is this an XML file?");
    }
    next_ += between.size();
    const std::string_view rest = text_.substr(next_);
    if (rest.empty()) {
      if (!open_.empty()) fail("the file ends within the element " + in_quotes(open_.back()));
      if (!has_root_) fail("no XML element in the file");
      return Event::Finished;
    }
    if (rest.starts_with("<!--")) {
      skip_past("-->", "a comment");
    } else if (rest.starts_with("<?")) {
      skip_past("?>", "a processing instruction");
    } else if (rest.starts_with("<!")) {
      fail("document types and CDATA sections are not read");
    } else {
      ++next_;
      return rest.starts_with("</") ? end_tag() : start_tag();
    }
  }
}

XmlReader::Event XmlReader::start_tag() {
  constexpr std::size_t deepest = 100, most_attributes = 100;
  if (open_.empty() && has_root_) fail("a second root element");
  if (open_.size() == deepest) fail("elements are nested more than " + std::to_string(deepest) + " deep");
  has_root_ = true;
  tag_ = read_name();
  attributes_.clear();
  skip_space();
  while (next_ < text_.size() && text_[next_] != '>' && text_[next_] != '/') {  // ends: an attribute is not empty
    if (attributes_.size() == most_attributes)
      fail("an element has more than " + std::to_string(most_attributes) + " attributes");
    read_attribute();
    skip_space();
  }
  if (next_ < text_.size() && text_[next_] == '/') {
    ++next_;
    self_closed_ = true;
  }
  expect('>', "at the end of a tag");
  if (!self_closed_) open_.push_back(tag_);
  return Event::Start;
}

XmlReader::Event XmlReader::end_tag() {
  ++next_;
  tag_ = read_name();
  skip_space();
  expect('>', "at the end of a tag");
  if (open_.empty() || open_.back() != tag_)
    fail("the end of " + in_quotes(tag_) + " stands where " +
         (open_.empty() ? "no element is open" : "that of " + in_quotes(open_.back()) + " should"));
  open_.pop_back();
  return Event::End;
}

void XmlReader::read_attribute() {
  Attribute attribute{read_name(), {}};
  skip_space();
  expect('=', "after an attribute's name");
  skip_space();
  const char quote = next_ < text_.size() ? text_[next_] : '\0';
  if (quote != '"' && quote != '\'') fail("the value of attribute " + in_quotes(attribute.key) + " is not in quotes");
  const std::size_t end = text_.find(quote, ++next_);
  if (end == std::string_view::npos) fail("the file ends within the value of attribute " + in_quotes(attribute.key));
  const std::string_view value = text_.substr(next_, end - next_);
  if (value.find('<') != std::string_view::npos) fail("a '<' stands in the value of " + in_quotes(attribute.key));
  if (std::ranges::find(attributes_, attribute.key, &Attribute::key) != attributes_.end())
    fail("attribute " + in_quotes(attribute.key) + " stands twice");
  attribute.value = unescape(value);
  next_ = end + 1;
  attributes_.push_back(std::move(attribute));
}

std::string XmlReader::attribute(std::string_view key, std::string_view fallback) const {
  const auto found = std::ranges::find(attributes_, key, &Attribute::key);
  return found == attributes_.end() ? std::string(fallback) : found->value;
}

std::string XmlReader::attribute(std::string_view key) const {
  const auto found = std::ranges::find(attributes_, key, &Attribute::key);
  if (found == attributes_.end()) fail("element " + in_quotes(tag_) + " has no attribute " + in_quotes(key));
  return found->value;
}

std::string_view XmlReader::text() const {
  return self_closed_ ? std::string_view() : text_.substr(next_, text_.find('<', next_) - next_);
}

void XmlReader::skip_element() {
  const std::size_t depth = open_.size() - (self_closed_ ? 0 : 1);
  do {  // ends: every turn passes a tag, and the text's end throws while an element is open
    next();
  } while (open_.size() > depth);
}

void XmlReader::skip_past(std::string_view end, const char* what) {
  const std::size_t place = text_.find(end, next_);
  if (place == std::string_view::npos) fail(std::string("the file ends within ") + what);
  next_ = place + end.size();
}

void XmlReader::skip_space() {
  next_ = std::min(text_.find_first_not_of(space, next_), text_.size());
}

std::string_view XmlReader::read_name() {
  const std::size_t end = std::min(text_.find_first_of(" \t\r\n=/><\"'&", next_), text_.size());
  const std::string_view name = text_.substr(next_, end - next_);
  if (name.empty()) fail("a name should stand here");
  next_ = end;
  return name;
}

void XmlReader::expect(char c, const char* where) {
  if (next_ >= text_.size()) fail(std::string("the file ends where '") + c + "' should follow");
  if (text_[next_] != c) fail(in_quotes(text_.substr(next_, 1)) + " stands where '" + c + "' should, " + where);
  ++next_;
}

std::string XmlReader::unescape(std::string_view value) const {
  std::string result;
  while (!value.empty()) {  // ends: every turn takes a character
    const auto entity = std::ranges::find_if(entities, [&](const auto& e) { return value.starts_with(e.second); });
    if (entity != entities.end()) {
      result += entity->first;
      value.remove_prefix(entity->second.size());
    } else if (value[0] == '&') {
      fail(in_quotes(value) + ": only the entities amp, lt, gt, quot and apos are read");
    } else {
      result += value[0];
      value.remove_prefix(1);
    }
  }
  return result;
}

std::size_t XmlReader::line() const {
  return line_of_tag_at_ + static_cast<std::size_t>(std::ranges::count(text_.substr(tag_at_, next_ - tag_at_), '\n'));
}

void XmlReader::fail(const std::string& problem) const {
  throw_at_line(name_, line(), problem);
}

std::string xml_escape(std::string_view value) {
  std::string result;
  for (const char c : value) {
    if (static_cast<unsigned char>(c) < 0x20)
      throw base::InputError(in_quotes(value) + " holds a control character, which XML cannot hold");
    const auto entity = std::ranges::find(entities, c, &std::pair<char, std::string_view>::first);
    result += entity == entities.end() ? std::string_view(&c, 1) : entity->second;
  }
  return result;
}

}  // namespace lostopos
