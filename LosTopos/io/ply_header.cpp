#include "LosTopos/io/ply_header.h"

#include <algorithm>
#include <array>
#include <set>

#include "Base/io/number_text.h"
#include "LosTopos/io/read_error.h"
#include "LosTopos/io/text_reader.h"

namespace lostopos {
namespace {

struct TypeName {
  std::string_view name, other_name;
  std::size_t size;
};
// In the order of PlyType.
constexpr std::array<TypeName, 8> type_names{{{"char", "int8", 1},
                                              {"uchar", "uint8", 1},
                                              {"short", "int16", 2},
                                              {"ushort", "uint16", 2},
                                              {"int", "int32", 4},
                                              {"uint", "uint32", 4},
                                              {"float", "float32", 4},
                                              {"double", "float64", 8}}};

class HeaderParser {
 public:
  explicit HeaderParser(ByteReader& bytes) : bytes_(bytes) {}

  PlyHeader parse() {
    require_magic();
    bool has_format = false;
    for (;;) {  // ends: every turn consumes a line of the file
      next_line();
      const std::string_view keyword = word();
      if (keyword == "end_header") break;
      if (keyword == "format") {
        parse_format();
        has_format = true;
      } else if (keyword == "element") {
        parse_element();
      } else if (keyword == "property") {
        parse_property();
      } else if (!keyword.empty() && keyword != "comment" && keyword != "obj_info") {
        fail(in_quotes(keyword) + " is no word of a PLY header; format, element, property, comment and end_header are");
      }
    }
    if (!has_format) fail("the header has no line 'format'; 'format binary_little_endian 1.0' would be right");
    return std::move(header_);
  }

 private:
  void require_magic() {
    constexpr std::string_view magic = "ply";
    std::string start;
    while (start.size() < magic.size() + 1 && bytes_.remaining() > 0) start += bytes_.read<char>();
    bytes_.seek(0);
    header_.lines = 1;
    if (start != "ply\n" && start != "ply\r") fail("not a PLY file: it does not start with the line 'ply'");
    next_line();
    header_.lines = 1;
  }

  void next_line() {
    constexpr std::size_t longest_line = 1U << 16U;
    ++header_.lines;
    if (bytes_.remaining() == 0) fail("the file ends within the header; 'end_header' should follow");
    line_ = bytes_.read_line(longest_line);
    rest_ = line_;
  }
  std::string_view word() { return take_word(rest_); }

  void parse_format() {
    const std::string_view name = word();
    if (name == "ascii") {
      header_.encoding = PlyEncoding::Ascii;
    } else if (name == "binary_little_endian") {
      header_.encoding = PlyEncoding::LittleEndian;
    } else if (name == "binary_big_endian") {
      header_.encoding = PlyEncoding::BigEndian;
    } else {
      fail("format " + in_quotes(name) + " is not known; ascii, binary_little_endian and binary_big_endian are");
    }
    if (const std::string_view version = word(); version != "1.0")
      fail("version " + in_quotes(version) + " of the format is not known; 1.0 is");
  }

  void parse_element() {
    PlyElement element{std::string(word()), 0, {}};
    const std::string_view count = word();
    const auto number = base::parse_integer(count);
    if (element.name.empty() || !number || *number < 0)
      fail("an element needs a name and a count, but the count is " + in_quotes(count) +
           "; 'element vertex 12' would be right");
    element.count = static_cast<std::uint64_t>(*number);
    if (!element_names_.insert(element.name).second) fail("element " + in_quotes(element.name) + " is declared twice");
    property_names_.clear();
    header_.elements.push_back(std::move(element));
  }

  void parse_property() {
    if (header_.elements.empty()) fail("a property stands before the first element");
    PlyProperty property;
    std::string_view type = word();
    if (type == "list") {
      property.count_type = parse_type(word());
      type = word();
    }
    property.type = parse_type(type);
    property.name = word();
    if (property.name.empty()) fail("the property has no name; 'property double x' would be right");
    if (!property_names_.insert(property.name).second)
      fail("property " + in_quotes(property.name) + " is declared twice");
    header_.elements.back().properties.push_back(std::move(property));
  }

  PlyType parse_type(std::string_view name) {
    for (std::size_t i = 0; i < type_names.size(); ++i)
      if (name == type_names[i].name || name == type_names[i].other_name) return static_cast<PlyType>(i);
    fail("type " + in_quotes(name) + " is not known; char, uchar, short, ushort, int, uint, float and double are");
  }

  [[noreturn]] void fail(const std::string& problem) const { throw_at_line(bytes_.name(), header_.lines, problem); }

  ByteReader& bytes_;
  PlyHeader header_;
  std::set<std::string> element_names_, property_names_;  // the latter of the last element
  std::string line_;
  std::string_view rest_;
};

}  // namespace

std::size_t ply_size(PlyType type) {
  return type_names[static_cast<std::size_t>(type)].size;
}

std::optional<std::size_t> PlyElement::find(std::initializer_list<std::string_view> names) const {
  for (std::size_t i = 0; i < properties.size(); ++i)
    if (std::ranges::find(names, properties[i].name) != names.end()) return i;
  return std::nullopt;
}

PlyHeader read_ply_header(ByteReader& bytes) {
  return HeaderParser(bytes).parse();
}

}  // namespace lostopos
