#include "LosTopos/run/checkpoint.h"

#include <algorithm>
#include <cstdint>
#include <fstream>
#include <new>
#include <nlohmann/json.hpp>
#include <utility>

#include "Base/error.h"
#include "Base/interruption.h"
#include "Base/io/atomic_file.h"
#include "LosTopos/run/cbor_form.h"
#include "LosTopos/run/sealed_bytes.h"

namespace lostopos::run {

using nlohmann::json;

namespace {

constexpr std::uint64_t most_bytes = std::uint64_t{1} << 34;
constexpr std::string_view kind = " checkpoint";

std::vector<std::uint8_t> read_bytes(const std::filesystem::path& file) {
  std::error_code error;
  const auto size = std::filesystem::file_size(file, error);
  std::ifstream in(file, std::ios::binary);
  if (error == std::errc::no_such_file_or_directory && std::filesystem::exists(file.parent_path() / "run.json"))
    throw base::FileError("the run in " + file.parent_path().string() + " has ended before its first checkpoint " +
                          file.filename().string() + ": run its command, which run.json has, once more with --force");
  if (error || !in)
    throw base::FileError("cannot read the checkpoint " + file.string() + "; give a run's checkpoint.cbor");
  if (size > most_bytes) throw base::InputError(file.string() + " is too large to be a checkpoint");
  std::vector<std::uint8_t> bytes(size);
  in.read(reinterpret_cast<char*>(bytes.data()), static_cast<std::streamsize>(size));
  if (in.gcount() != static_cast<std::streamsize>(size))
    throw base::FileError("cannot read the checkpoint " + file.string() + " to its end");
  return bytes;
}

// "foamsim checkpoint of version 4"; empty for what is none.
std::string described(const json& content) {
  if (!content.is_object() || !content.contains("format") || !content["format"].is_string()) return {};
  const std::string format = content["format"];
  if (!format.ends_with(kind) || !content.contains("version") || !content["version"].is_number_integer()) return {};
  return format + " of version " + content["version"].dump();
}

json parsed(std::span<const std::uint8_t> bytes) {
  return is_plain_cbor(bytes) ? json::from_cbor(bytes.begin(), bytes.end()) : json();
}

// Before they had a head, checkpoints were their content alone.
json content_of(std::span<const std::uint8_t> bytes) {
  if (begin_sealed(bytes)) return parsed(unsealed(bytes));
  if (const std::string old = described(parsed(bytes)); !old.empty())
    throw base::InputError("it is a " + old +
                           ", from before they had checksums; this program writes and reads later ones");
  return parsed(unsealed(bytes));
}

std::string in_one_line(std::string text) {
  std::ranges::replace_if(
      text, [](unsigned char c) { return c < ' ' || c == 0x7f; }, ' ');
  return text;
}

}  // namespace

// A large surface is there once in `content` and once in the bytes, and no more often.
std::vector<std::uint8_t> checkpoint_bytes(const CheckpointFormat& format, json content) {
  content["format"] = format.program + std::string(kind);
  content["version"] = format.version;
  std::vector<std::uint8_t> bytes = room_for_head();
  json::to_cbor(content, bytes);
  seal(bytes);
  return bytes;
}

void write_checkpoint(const std::filesystem::path& file, const CheckpointFormat& format, json content) {
  const std::vector<std::uint8_t> bytes = checkpoint_bytes(format, std::move(content));
  base::AtomicFile out(file, base::Durability::machine);
  out.stream().write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
  out.commit();
}

void take_checkpoint(std::span<const std::uint8_t> bytes, const std::string& name, const CheckpointFormat& format,
                     const TakeCheckpoint& take) {
  try {
    const json content = content_of(bytes);
    const std::string asked = format.program + std::string(kind) + " of version " + std::to_string(format.version);
    if (const std::string what = described(content); what != asked)
      throw base::InputError("it is " + (what.empty() ? "none" : "a " + what) + ", where a " + asked + " belongs");
    take(content);
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const base::Interrupted&) {
    throw;
  } catch (const std::exception& problem) {
    throw base::InputError(in_one_line(name + " is not a whole checkpoint: " + problem.what()));
  }
}

void read_checkpoint(const std::filesystem::path& file, const CheckpointFormat& format, const TakeCheckpoint& take) {
  take_checkpoint(read_bytes(file), file.string(), format, take);
}

}  // namespace lostopos::run
