#include "LosTopos/io/ply_values.h"

#include <cmath>

#include "Base/io/number_text.h"
#include "LosTopos/io/read_error.h"

namespace lostopos {

std::int64_t PlyValues::next_integer(PlyType type, const char* what) {
  const double value = next(type);
  constexpr double largest = 9007199254740992.0;  // 2^53: up to here doubles hold all whole numbers
  if (!(std::abs(value) <= largest) || value != std::floor(value)) {
    std::string text = std::string(what) + " is ";
    base::append_number(text, value);
    fail(text + "; it has to be a whole number");
  }
  return static_cast<std::int64_t>(value);
}

void PlyValues::skip_property(const PlyProperty& property) {
  if (!property.is_list()) {
    skip_values(1, property.type);
    return;
  }
  const std::int64_t count = next_integer(*property.count_type, "a list's length");
  if (count < 0) fail("a list has the length " + std::to_string(count));
  skip_values(static_cast<std::uint64_t>(count), property.type);
}

double PlyBinaryValues::next(PlyType type) {
  switch (type) {
    case PlyType::Int8:
      return bytes_.read<std::int8_t>(order_);
    case PlyType::Uint8:
      return bytes_.read<std::uint8_t>(order_);
    case PlyType::Int16:
      return bytes_.read<std::int16_t>(order_);
    case PlyType::Uint16:
      return bytes_.read<std::uint16_t>(order_);
    case PlyType::Int32:
      return bytes_.read<std::int32_t>(order_);
    case PlyType::Uint32:
      return bytes_.read<std::uint32_t>(order_);
    case PlyType::Float32:
      return static_cast<double>(bytes_.read<float>(order_));
    case PlyType::Float64:
      break;
  }
  return bytes_.read<double>(order_);
}

void PlyBinaryValues::skip_values(std::uint64_t count, PlyType type) {
  bytes_.require_records(count, ply_size(type), "list entries");
  bytes_.skip(count * ply_size(type));
}

void PlyBinaryValues::require_room(const PlyElement& element) const {
  std::uint64_t least = 0;  // every list empty
  for (const PlyProperty& property : element.properties) least += ply_size(property.count_type.value_or(property.type));
  bytes_.require_records(element.count, least, "records of element " + in_quotes(element.name));
}

void PlyBinaryValues::require_end() {
  if (bytes_.remaining() > 0)
    fail("the header's last element ends here, but " + std::to_string(bytes_.remaining()) +
         " bytes follow; a count or a type in the header is wrong");
}

double PlyAsciiValues::next(PlyType) {
  return text_.number("a property's value");
}

void PlyAsciiValues::skip_values(std::uint64_t count, PlyType) {
  text_.require_records(count, 1, "list entries");
  for (std::uint64_t i = 0; i < count; ++i) text_.number("a property's value");
}

void PlyAsciiValues::require_room(const PlyElement& element) const {
  text_.require_records(element.count, element.properties.size(), "records of element " + in_quotes(element.name));
}

void PlyAsciiValues::require_end() {
  if (const std::string_view word = text_.next_word(); !word.empty())
    fail(in_quotes(word) + " follows the last element; a count in the header is too small");
}

}  // namespace lostopos
