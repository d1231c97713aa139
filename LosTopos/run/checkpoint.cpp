#include "LosTopos/run/checkpoint.h"

#include <cstdint>
#include <fstream>
#include <nlohmann/json.hpp>
#include <vector>

#include "Base/error.h"
#include "Base/io/atomic_file.h"

namespace lostopos::run {

using nlohmann::json;

namespace {

constexpr std::uint64_t most_bytes = std::uint64_t{1} << 34;

std::string format_text(const CheckpointFormat& format) {
  return format.program + " checkpoint";
}

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
  return bytes;
}

}  // namespace

void write_checkpoint(const std::filesystem::path& file, const CheckpointFormat& format, const json& content) {
  json value = content;
  value["format"] = format_text(format);
  value["version"] = format.version;
  const std::vector<std::uint8_t> bytes = json::to_cbor(value);
  base::AtomicFile out(file, base::Durability::machine);
  out.stream().write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
  out.commit();
}

void read_checkpoint(const std::filesystem::path& file, const CheckpointFormat& format,
                     const std::function<void(const json& content)>& take) {
  const std::vector<std::uint8_t> bytes = read_bytes(file);
  try {
    const json value = json::from_cbor(bytes);
    if (value.at("format") != format_text(format) || value.at("version") != format.version)
      throw base::InputError("it is not a " + format_text(format) + " of version " + std::to_string(format.version));
    take(value);
  } catch (const json::exception& problem) {
    throw base::InputError(file.string() + " is not a whole checkpoint: " + problem.what());
  } catch (const base::Error& problem) {
    throw base::InputError(file.string() + " is not a whole checkpoint: " + problem.what());
  }
}

}  // namespace lostopos::run
