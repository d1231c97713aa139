#pragma once

#include <optional>
#include <string>

namespace base {

/// Memory that programs of this machine can still take without paging, in bytes; none where the system does not say.
std::optional<double> available_memory();

/// Bytes in words, to two digits: "160 MB".
std::string bytes_in_words(double bytes);

}  // namespace base
