#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "LosTopos/mesh/attribute_codec.h"

namespace lostopos {

/// The values of a named attribute, of whatever type, apart from a mesh.
class StoredValues {
 public:
  StoredValues() = default;
  virtual ~StoredValues() = default;
  virtual std::unique_ptr<StoredValues> clone() const = 0;
  virtual std::size_t size() const = 0;
  /// See AttributeCodec.
  virtual std::string type() const = 0;
  virtual std::vector<std::uint8_t> encoded() const = 0;
  virtual std::size_t memory_bytes() const = 0;

 protected:
  StoredValues(const StoredValues&) = default;
  StoredValues& operator=(const StoredValues&) = default;
};

/// Values as an attribute has them.
template <Storable T>
class StoredVector final : public StoredValues {
 public:
  std::unique_ptr<StoredValues> clone() const override { return std::make_unique<StoredVector>(*this); }
  std::size_t size() const override { return values.size(); }
  std::string type() const override { return AttributeCodec<T>::type(); }
  std::vector<std::uint8_t> encoded() const override {
    std::vector<std::uint8_t> bytes;
    AttributeCodec<T>::encode(values, bytes);
    return bytes;
  }
  std::size_t memory_bytes() const override { return values.capacity() * sizeof(T); }

  std::vector<T> values;
};

/// Values from a file, whose type is not known until an attribute asks for them.
class EncodedValues final : public StoredValues {
 public:
  EncodedValues(std::string type, std::size_t size, std::vector<std::uint8_t> bytes)
      : type_(std::move(type)), size_(size), bytes_(std::move(bytes)) {}
  std::unique_ptr<StoredValues> clone() const override { return std::make_unique<EncodedValues>(*this); }
  std::size_t size() const override { return size_; }
  std::string type() const override { return type_; }
  std::vector<std::uint8_t> encoded() const override { return bytes_; }
  std::size_t memory_bytes() const override { return bytes_.capacity(); }
  const std::vector<std::uint8_t>& bytes() const { return bytes_; }

 private:
  std::string type_;
  std::size_t size_;
  std::vector<std::uint8_t> bytes_;
};

/// A named attribute's values; a copy is deep.
struct StoredAttribute {
  std::string name;
  std::unique_ptr<StoredValues> values;

  StoredAttribute() = default;
  StoredAttribute(std::string its_name, std::unique_ptr<StoredValues> its_values)
      : name(std::move(its_name)), values(std::move(its_values)) {}
  StoredAttribute(const StoredAttribute& other)
      : name(other.name), values(other.values ? other.values->clone() : nullptr) {}
  StoredAttribute& operator=(const StoredAttribute& other) {
    if (this != &other) *this = StoredAttribute(other);
    return *this;
  }
  StoredAttribute(StoredAttribute&&) noexcept = default;
  StoredAttribute& operator=(StoredAttribute&&) noexcept = default;
  ~StoredAttribute() = default;
};

}  // namespace lostopos
