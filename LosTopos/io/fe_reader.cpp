#include <algorithm>
#include <cmath>

#include "Base/error.h"
#include "Base/io/number_text.h"
#include "LosTopos/io/byte_reader.h"
#include "LosTopos/io/fe.h"
#include "LosTopos/io/fe_bodies.h"
#include "LosTopos/io/fe_keywords.h"
#include "LosTopos/io/fe_numbers.h"
#include "LosTopos/io/read_error.h"
#include "LosTopos/io/surface_checks.h"

namespace lostopos {
namespace {

constexpr std::int64_t largest_fe_number = 0x7fffffff;

class FeReader {
 public:
  explicit FeReader(const std::filesystem::path& path)
      : name_(path.string()), text_(ByteReader(path).read_text(), name_) {}

  SurfaceData read() {
    while (text_.next_line()) {
      const std::string keyword = small_letters(word_ = text_.next_word());
      if (keyword == "read") break;  // commands are behind it
      if (const auto section = fe_section(keyword)) {
        begin(*section);
      } else if (section_ != FeSection::head) {
        read_element();
      } else if (goes_on_ && !starts_a_keyword(keyword)) {
        continue;  // numbers of a declaration that was passed over
      } else {
        pass_fe_declaration(text_, keyword);
        goes_on_ = true;
      }
    }
    if (section_ < FeSection::facets)
      text_.fail(
          "the file ends before its facets; a datafile of Surface Evolver has vertices, edges, faces and bodies");
    end_section();
    finish();
    return std::move(data_);
  }

 private:
  static bool starts_a_keyword(std::string_view word) {
    return (word[0] >= 'a' && word[0] <= 'z') || word[0] == '#' || word[0] == '_';
  }

  void begin(FeSection section) {
    const bool next = static_cast<int>(section) == static_cast<int>(section_) + 1;
    if (!next) text_.fail(in_quotes(word_) + " stands here; vertices, edges, faces, bodies is the order, each once");
    if (!text_.next_word().empty()) text_.fail("the line should end behind " + in_quotes(word_));
    end_section();
    section_ = section;
  }

  void end_section() {
    if (section_ == FeSection::head || section_ == FeSection::bodies) return;
    if (const auto twice = numbers().sort())
      throw_at_line(name_, twice->line,
                    std::string(fe_element(section_)) + " " + std::to_string(twice->number) + " is there before");
  }

  FeNumbers& numbers() {
    return section_ == FeSection::vertices ? vertex_numbers_ : section_ == FeSection::edges ? edge_numbers_ : facets_;
  }

  void read_element() {
    const auto number = base::parse_integer(word_);
    if (!number || *number < 1 || *number > largest_fe_number)
      text_.fail(in_quotes(word_) + " stands where the number of the next " + std::string(fe_element(section_)) +
                 " should; 1 to " + std::to_string(largest_fe_number) + " would be right");
    element_ = static_cast<std::uint32_t>(*number);
    if (section_ != FeSection::bodies) add_number();
    switch (section_) {
      case FeSection::vertices:
        return read_vertex();
      case FeSection::edges:
        return read_edge();
      case FeSection::facets:
        return read_facet();
      default:
        return read_body();
    }
  }

  void add_number() {
    if (static_cast<std::int64_t>(numbers().entries().size()) == largest_fe_number)
      text_.fail("there are more elements than numbers");
    numbers().add(element_, text_.line_number());
  }

  void read_vertex() {
    Vec3 position;
    for (int i = 0; i < 3; ++i) position[i] = text_.number("a coordinate");
    reject(position_problem(position));
    reject(vertex_count_problem(data_.positions.size() + 1));
    const auto vertex = static_cast<std::uint32_t>(data_.positions.size());
    data_.positions.push_back(position);
    take_attributes(text_.next_word(), [&](FeAttribute attribute) {
      if (attribute == FeAttribute::fixed) data_.held.push_back({vertex, position});
    });
  }

  void read_edge() {
    std::array<std::uint32_t, 2> ends{};
    for (std::uint32_t& end : ends) {
      const std::int64_t number = text_.integer("a vertex");
      const auto vertex = vertex_numbers_.find(number);
      if (!vertex || number < 0) text_.fail("vertex " + std::to_string(number) + " does not exist");
      end = *vertex;
    }
    if (ends[0] == ends[1]) text_.fail("the edge ends at the vertex at which it begins");
    edges_.push_back(ends);
    take_attributes(text_.next_word(), [](FeAttribute) {});
  }

  void read_facet() {
    std::array<std::uint32_t, 3> corners{};
    std::uint32_t end = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      const auto [from, to] = directed_edge(text_.integer("an edge"));
      if (i > 0 && from != end) text_.fail("the facet's edges do not follow each other round it");
      corners[i] = from;
      end = to;
    }
    if (end != corners[0]) fail_of_open_facet();
    reject(triangle_count_problem(data_.triangles.size() + 1));
    const auto facet = static_cast<std::uint32_t>(data_.triangles.size());
    data_.triangles.push_back(corners);
    bodies_.add_facet();
    tensions_.push_back(1);
    take_attributes(text_.next_word(), [&](FeAttribute attribute) { take_of_facet(attribute, facet); });
  }

  std::array<std::uint32_t, 2> directed_edge(std::int64_t number) const {
    const auto edge = edge_numbers_.find(number);
    if (!edge) text_.fail("edge " + std::to_string(number) + " does not exist");
    const auto [from, to] = edges_[*edge];
    return number > 0 ? std::array{from, to} : std::array{to, from};
  }

  [[noreturn]] void fail_of_open_facet() {
    if (base::parse_integer(text_.next_word()))
      text_.fail("the facet has more than three edges; let Evolver read this file and dump it, it makes triangles");
    text_.fail("the facet's three edges do not close");
  }

  void take_of_facet(FeAttribute attribute, std::uint32_t facet) {
    if (attribute == FeAttribute::tension) {
      const double tension = text_.number("a tension");
      if (!std::isfinite(tension) || tension < 0) text_.fail("a tension has to be finite, and not negative");
      tensions_[facet] = tension;
    } else if (attribute == FeAttribute::front_body || attribute == FeAttribute::back_body) {
      const auto side = attribute == FeAttribute::front_body ? FeBodies::Side::front : FeBodies::Side::back;
      reject(bodies_.add(facet, side, text_.integer("a body")));
    }
  }

  void read_body() {
    std::string_view word = text_.next_word();
    for (auto number = base::parse_integer(word); number; number = base::parse_integer(word)) {
      const auto facet = facets_.find(*number);
      if (!facet) text_.fail("facet " + std::to_string(*number) + " does not exist");
      reject(bodies_.add(*facet, *number > 0 ? FeBodies::Side::back : FeBodies::Side::front, element_));
      word = text_.next_word();
    }
    std::int64_t region = element_;
    take_attributes(word, [&](FeAttribute attribute) {
      if (attribute == FeAttribute::original) region = text_.integer("a body");
    });
    if (region < 1 || region > largest_region)
      text_.fail("a body's original number cannot be " + std::to_string(region));
    bodies_.declare(element_, static_cast<std::uint32_t>(region), text_.line_number());
  }

  template <class Take>
  void take_attributes(std::string_view word, Take take) {
    for (; !word.empty(); word = text_.next_word()) {
      const FeAttribute attribute = take_fe_attribute(text_, section_, small_letters(word));
      if (attribute != FeAttribute::none) take(attribute);
    }
  }

  void finish() {
    data_.labels = bodies_.labels(name_, facets_);
    if (std::ranges::any_of(tensions_, [](double tension) { return tension != 1; }))
      data_.triangle_arrays.push_back({tension_array, 1, std::move(tensions_)});
    require_edges_in_range(data_, name_);
  }

  void reject(const std::string& problem) {
    if (!problem.empty()) text_.fail(problem);
  }

  std::string name_;
  FeText text_;
  std::string_view word_;  // the first of the line
  FeSection section_ = FeSection::head;
  bool goes_on_ = false;
  std::uint32_t element_ = 0;  // its number
  FeNumbers vertex_numbers_, edge_numbers_, facets_;
  std::vector<std::array<std::uint32_t, 2>> edges_;
  std::vector<double> tensions_;
  FeBodies bodies_;
  SurfaceData data_;
};

}  // namespace

SurfaceData read_fe(const std::filesystem::path& path) {
  return FeReader(path).read();
}

bool starts_like_fe(std::string_view start) {
  try {
    FeText text(std::string(start), {});
    if (!text.next_line()) return false;
    const std::string keyword = small_letters(text.next_word());
    return fe_section(keyword) == FeSection::vertices || is_fe_declaration(keyword);
  } catch (const base::InputError&) {
    return false;  // a comment that ends behind what is known
  }
}

}  // namespace lostopos
