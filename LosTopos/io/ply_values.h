#pragma once

#include <cstdint>
#include <string>

#include "Base/error.h"
#include "LosTopos/io/byte_reader.h"
#include "LosTopos/io/ply_header.h"
#include "LosTopos/io/text_reader.h"

namespace lostopos {

/// The numbers of a PLY file's body one after another, whatever its encoding. All scalar types fit a double exactly.
class PlyValues {
 public:
  PlyValues() = default;
  PlyValues(const PlyValues&) = delete;
  PlyValues& operator=(const PlyValues&) = delete;
  virtual ~PlyValues() = default;

  virtual double next(PlyType type) = 0;
  /// Passes over `count` values of a list.
  virtual void skip_values(std::uint64_t count, PlyType type) = 0;
  /// Throws InputError when the element's records cannot all stand in the rest of the file.
  virtual void require_room(const PlyElement& element) const = 0;
  /// Throws InputError when something follows.
  virtual void require_end() = 0;
  /// Makes this the place that `fail` names in a binary file.
  virtual void begin_record() {}
  [[noreturn]] void fail(const std::string& problem) const { throw base::InputError(place() + ": " + problem); }

  /// The next value, which has to be a whole number; `what` says what it stands for.
  std::int64_t next_integer(PlyType type, const char* what);
  /// Passes over one property, list or scalar.
  void skip_property(const PlyProperty& property);

 private:
  /// File and place in it, for messages.
  virtual std::string place() const = 0;
};

class PlyBinaryValues final : public PlyValues {
 public:
  /// `bytes` has just read the header.
  PlyBinaryValues(ByteReader& bytes, std::endian order) : bytes_(bytes), order_(order), record_(bytes.position()) {}
  double next(PlyType type) override;
  void skip_values(std::uint64_t count, PlyType type) override;
  void require_room(const PlyElement& element) const override;
  void require_end() override;
  void begin_record() override { record_ = bytes_.position(); }

 private:
  std::string place() const override { return bytes_.name() + ", byte " + std::to_string(record_); }

  ByteReader& bytes_;
  std::endian order_;
  std::uint64_t record_;  // where the present record starts
};

class PlyAsciiValues final : public PlyValues {
 public:
  /// `bytes` has just read the header, which had that many lines.
  PlyAsciiValues(ByteReader& bytes, std::size_t header_lines)
      : text_(bytes.read_text(), bytes.name(), header_lines + 1) {}
  double next(PlyType type) override;
  void skip_values(std::uint64_t count, PlyType type) override;
  void require_room(const PlyElement& element) const override;
  void require_end() override;

 private:
  std::string place() const override { return text_.place(); }

  TextReader text_;
};

}  // namespace lostopos
