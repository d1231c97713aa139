#include "LosTopos/run/sealed_bytes.h"

#include <algorithm>
#include <array>
#include <boost/crc.hpp>
#include <cstring>
#include <string>

#include "Base/error.h"

namespace lostopos::run {
namespace {

// As PNG's: what changes line ends or the eighth bit changes it.
constexpr std::array<std::uint8_t, 8> magic{0x89, 'F', 'o', 'a', 'm', '\r', '\n', 0x1a};
constexpr std::uint32_t head_version = 1;

struct Head {
  std::array<std::uint8_t, 8> magic;
  std::uint32_t version, checksum;
  std::uint64_t length;
};
static_assert(sizeof(Head) == 24);

std::uint32_t checksum_of(const Head& head, std::span<const std::uint8_t> content) {
  boost::crc_32_type crc;
  crc.process_bytes(&head.version, sizeof(head.version));
  crc.process_bytes(&head.length, sizeof(head.length));
  crc.process_bytes(content.data(), content.size());
  return crc.checksum();
}

}  // namespace

std::vector<std::uint8_t> room_for_head() {
  return std::vector<std::uint8_t>(sizeof(Head));
}

void seal(std::vector<std::uint8_t>& bytes) {
  const auto content = std::span<const std::uint8_t>(bytes).subspan(sizeof(Head));
  Head head{magic, head_version, 0, content.size()};
  head.checksum = checksum_of(head, content);
  std::memcpy(bytes.data(), &head, sizeof(head));
}

std::vector<std::uint8_t> sealed(std::span<const std::uint8_t> content) {
  std::vector<std::uint8_t> bytes = room_for_head();
  bytes.insert(bytes.end(), content.begin(), content.end());
  seal(bytes);
  return bytes;
}

bool begin_sealed(std::span<const std::uint8_t> bytes) {
  return bytes.size() >= magic.size() && std::ranges::equal(bytes.first(magic.size()), magic);
}

std::span<const std::uint8_t> unsealed(std::span<const std::uint8_t> bytes) {
  if (!begin_sealed(bytes)) throw base::InputError("it does not begin as one");
  if (bytes.size() < sizeof(Head))
    throw base::InputError("it is cut off after " + std::to_string(bytes.size()) + " bytes");
  Head head{};
  std::memcpy(&head, bytes.data(), sizeof(head));
  const auto content = bytes.subspan(sizeof(head));
  if (head.version != head_version)
    throw base::InputError("its form is of version " + std::to_string(head.version) +
                           ", where this program knows version " + std::to_string(head_version));
  if (head.length != content.size())
    throw base::InputError("it says that " + std::to_string(head.length) + " bytes follow its head, and " +
                           std::to_string(content.size()) + " do: it is cut off or damaged");
  if (checksum_of(head, content) != head.checksum)
    throw base::InputError("it is damaged: its checksum is not that of its content");
  return content;
}

}  // namespace lostopos::run
