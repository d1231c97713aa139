#pragma once

#include <cstdint>
#include <span>

namespace lostopos::run {

/// Whether `bytes` are one whole CBOR value (RFC 8949) of the forms that a checkpoint is written in: everything has its
/// length, nothing is tagged, and no more than a few dozen lists and objects lie within each other. Such bytes cost a
/// reader no more memory than a few times their number, and no deep recursion.
bool is_plain_cbor(std::span<const std::uint8_t> bytes);

}  // namespace lostopos::run
