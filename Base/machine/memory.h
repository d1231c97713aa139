#pragma once

#include <optional>
#include <string>

namespace base {

/// Memory that programs of this machine can still take without paging, in bytes; none where the system does not say.
std::optional<double> available_memory();

/// From now on, blocks of a MB and more go back to the system as soon as they are freed, where the C library can be
/// told so (glibc). By itself it keeps what it had once, in pieces that later blocks do not fit into. That saves up to
/// a fifth of a large run's memory and takes up to half again its time, since pages have to be had anew.
void give_back_large_blocks();

/// Bytes in words, to two digits: "160 MB".
std::string bytes_in_words(double bytes);

}  // namespace base
