#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace lostopos {

/// Walks through the tags of an XML text one after another and checks that it is well-formed. Comments and processing
/// instructions are passed over; document types and CDATA, which the formats here do not use, are refused. Every error
/// is an InputError that names the file and the line. Nesting is bounded, memory is that of the text.
class XmlReader {
 public:
  enum class Event { Start, End, Finished };

  /// `text` must outlive the reader; `name`: the file's, for messages.
  XmlReader(std::string_view text, std::string name);

  /// Goes on to the next tag: Start of an element (then `tag`, `attribute` and `text` tell about it), End of the one
  /// named `tag`, or Finished when the root element has ended and nothing follows.
  Event next();
  std::string_view tag() const { return tag_; }
  /// Value of an attribute of the element just started, or `fallback`.
  std::string attribute(std::string_view key, std::string_view fallback) const;
  /// The same; throws InputError when there is none.
  std::string attribute(std::string_view key) const;
  /// The characters between the tag just passed and the next one, as they stand.
  std::string_view text() const;
  /// Goes on to behind the end of the element just started, whatever it holds.
  void skip_element();

  const std::string& name() const { return name_; }
  /// Line of the next character, from 1.
  std::size_t line() const;
  [[noreturn]] void fail(const std::string& problem) const;

 private:
  struct Attribute {
    std::string_view key;
    std::string value;
  };

  Event start_tag();
  Event end_tag();
  void skip_past(std::string_view end, const char* what);
  void skip_space();
  std::string_view read_name();
  void read_attribute();
  void expect(char c, const char* where);
  std::string unescape(std::string_view value) const;

  std::string_view text_;
  std::string name_;
  std::size_t next_ = 0;    // place of the next character
  std::size_t tag_at_ = 0;  // place behind the last tag but one
  std::size_t line_of_tag_at_ = 1;
  std::string_view tag_;
  std::vector<Attribute> attributes_;
  std::vector<std::string_view> open_;  // elements not yet ended
  bool self_closed_ = false;
  bool has_root_ = false;
};

/// `value` with the characters that XML reserves replaced, fit for an attribute in double quotes. Throws InputError for
/// control characters, which XML cannot hold.
std::string xml_escape(std::string_view value);

}  // namespace lostopos
