#pragma once

#include <concepts>
#include <cstdint>
#include <cstring>
#include <optional>
#include <span>
#include <string>
#include <type_traits>
#include <vector>

#include "LosTopos/vec3.h"

namespace lostopos {

/// How values of type T are stored as bytes (in the machine's order) and as numbers. A named attribute needs one for
/// its type: specialise it for others, with
/// - `static std::string type()`, which a stored array is recognised by;
/// - `static void encode(std::span<const T>, std::vector<std::uint8_t>&)`, appending;
/// - `static std::optional<std::vector<T>> decode(std::span<const std::uint8_t>)`, nothing for bytes that do not fit;
/// - `static constexpr int components`: numbers a value has in .vtp files, 0 for a type that is no number;
/// - `static double number(const T&, int i)` of component i, where there are components.
template <class T>
struct AttributeCodec;

/// A type that can be the type of a named attribute.
template <class T>
concept Storable = requires {
  AttributeCodec<T>::components;
};

/// For values that are copied byte by byte.
template <class T>
struct PlainCodec {
  static_assert(std::is_trivially_copyable_v<T>);
  static void encode(std::span<const T> values, std::vector<std::uint8_t>& bytes) {
    const std::size_t before = bytes.size();
    bytes.resize(before + values.size_bytes());
    if (!values.empty()) std::memcpy(bytes.data() + before, values.data(), values.size_bytes());
  }
  static std::optional<std::vector<T>> decode(std::span<const std::uint8_t> bytes) {
    if (bytes.size() % sizeof(T) != 0) return {};
    std::vector<T> values(bytes.size() / sizeof(T));
    if (!bytes.empty()) std::memcpy(values.data(), bytes.data(), bytes.size());
    return values;
  }
};

/// For values that are lists: how many members each has, and behind that the members as `Stored`, a plain struct.
/// `store` makes one of a member, `restore` a member of one.
template <class List, class Stored>
struct ListCodec {
  template <class Store>
  static void encode(std::span<const List> values, std::vector<std::uint8_t>& bytes, Store&& store) {
    std::vector<std::uint64_t> counts{values.size()};
    std::vector<Stored> members;
    for (const List& list : values) {
      counts.push_back(list.size());
      for (const auto& member : list) members.push_back(store(member));
    }
    PlainCodec<std::uint64_t>::encode(counts, bytes);
    PlainCodec<Stored>::encode(members, bytes);
  }
  template <class Restore>
  static std::optional<std::vector<List>> decode(std::span<const std::uint8_t> bytes, Restore&& restore) {
    constexpr std::size_t word = sizeof(std::uint64_t);
    if (bytes.size() < word) return {};
    const std::uint64_t lists = PlainCodec<std::uint64_t>::decode(bytes.first(word))->front();
    if (lists > bytes.size() / word - 1) return {};
    const auto counts = PlainCodec<std::uint64_t>::decode(bytes.subspan(word, lists * word));
    const auto members = PlainCodec<Stored>::decode(bytes.subspan((lists + 1) * word));
    if (!counts || !members) return {};
    std::vector<List> values(lists);
    std::size_t next = 0;
    for (std::size_t v = 0; v < lists; ++v) {
      if ((*counts)[v] > members->size() - next) return {};
      for (std::uint64_t i = 0; i < (*counts)[v]; ++i) values[v].push_back(restore((*members)[next++]));
    }
    if (next != members->size()) return {};
    return values;
  }
};

template <class T>
requires(std::is_arithmetic_v<T> && !std::same_as<T, bool>) struct AttributeCodec<T> : PlainCodec<T> {
  static std::string type() {
    const char* kind = std::is_floating_point_v<T> ? "float" : std::is_signed_v<T> ? "int" : "uint";
    return kind + std::to_string(8 * sizeof(T));
  }
  static constexpr int components = 1;
  static double number(const T& value, int) { return static_cast<double>(value); }
};

template <>
struct AttributeCodec<Vec3> {
  static std::string type() { return "vec3"; }
  static void encode(std::span<const Vec3> values, std::vector<std::uint8_t>& bytes) {
    for (const Vec3& x : values) PlainCodec<double>::encode({x.data(), 3}, bytes);
  }
  static std::optional<std::vector<Vec3>> decode(std::span<const std::uint8_t> bytes) {
    const auto numbers = PlainCodec<double>::decode(bytes);
    if (!numbers || numbers->size() % 3 != 0) return {};
    std::vector<Vec3> values;
    values.reserve(numbers->size() / 3);
    for (std::size_t i = 0; i < numbers->size(); i += 3)
      values.emplace_back((*numbers)[i], (*numbers)[i + 1], (*numbers)[i + 2]);
    return values;
  }
  static constexpr int components = 3;
  static double number(const Vec3& value, int i) { return value[i]; }
};

}  // namespace lostopos
