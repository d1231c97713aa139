#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace lostopos::run {

/// Room for a head, behind which content is to be appended.
std::vector<std::uint8_t> room_for_head();

/// Fills in the head: 8 bytes that say what it is, the version of the head, the length of the content, and a CRC-32 of
/// version, length and content (in the machine's byte order).
void seal(std::vector<std::uint8_t>& bytes);

/// `content` behind such a head.
std::vector<std::uint8_t> sealed(std::span<const std::uint8_t> content);

/// Whether `bytes` begin as sealed ones do.
bool begin_sealed(std::span<const std::uint8_t> bytes);

/// The content of sealed bytes. Throws base::InputError, which says what is wrong, where they do not begin as such,
/// are of another version, too few or too many, or not those that were sealed: any change of up to 32 bits that lie
/// together is found, and others but for one in 4 billion.
std::span<const std::uint8_t> unsealed(std::span<const std::uint8_t> bytes);

}  // namespace lostopos::run
