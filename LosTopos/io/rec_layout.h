#pragma once

#include "LosTopos/io/byte_reader.h"
#include "LosTopos/io/rec.h"

namespace lostopos {

/// Where things lie in a .rec file; offsets are those of the first record, behind the count.
struct RecLayout {
  RecFlavour flavour = RecFlavour::Tracker;
  std::uint64_t regions = 0;
  std::uint64_t vertices = 0, triangles = 0, held = 0;
  std::uint64_t vertices_at = 0, triangles_at = 0, held_at = 0;
};

/// Finds out the flavour: the one whose counts account for every byte. Throws InputError when neither does.
RecLayout find_rec_layout(ByteReader& bytes);

/// True when a file that starts with these bytes and has this size can be a .rec: for sniffing.
bool is_rec(ByteReader& bytes);

}  // namespace lostopos
