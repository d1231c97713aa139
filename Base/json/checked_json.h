#pragma once

#include <cstdint>
#include <limits>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

namespace base {

/// A value of a JSON document that comes from outside, and what messages call it ("last.impulse"). Whatever is not of
/// the kind asked for is an InputError that says so; `value` must outlive it.
class CheckedJson {
 public:
  CheckedJson(const nlohmann::json& value, std::string what) : value_(&value), what_(std::move(what)) {}

  const nlohmann::json& json() const { return *value_; }
  const std::string& what() const { return what_; }

  /// The member of an object. Throws InputError where there is none, or this is no object.
  CheckedJson at(const std::string& key) const;
  bool has(const std::string& key) const;
  /// The entries of a list. Throws InputError where this is none.
  std::vector<CheckedJson> entries() const;
  /// The entries of a list of so many.
  std::vector<CheckedJson> entries(std::size_t count) const;

  double finite_number() const;
  double positive_number() const;  ///< finite and > 0
  /// As many numbers, each finite.
  std::vector<double> finite_numbers(std::size_t count) const;
  std::int64_t whole_number(std::int64_t least = 0, std::int64_t most = std::numeric_limits<std::int64_t>::max()) const;
  /// The number of a mesh element or a region.
  std::uint32_t index() const;
  const std::string& text() const;
  /// Binary data, as CBOR has it.
  const std::vector<std::uint8_t>& bytes() const;

  /// Throws InputError with `message` behind the value's name.
  [[noreturn]] void refuse(const std::string& message) const;

 private:
  const nlohmann::json* value_;
  std::string what_;
};

}  // namespace base
