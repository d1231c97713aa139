#pragma once

#include <cstdint>
#include <span>
#include <string_view>

#include "LosTopos/run/checkpoint.h"

namespace fuzz {

/// Gives a reader a file of these bytes; whether it was read. An InputError is the other answer that it may give; every
/// other exception, and the end of the program, is a fault of the reader.
using Feed = bool(std::span<const std::uint8_t> bytes);

Feed feed_ply, feed_obj, feed_rec, feed_arec, feed_vtp, feed_vtu, feed_fe, feed_pvd;
Feed feed_toml, feed_grid, feed_options, feed_tracker_options;
/// A checkpoint of `plain_checkpoint`, whose content is nobody's.
Feed feed_checkpoint_file;
inline const lostopos::run::CheckpointFormat plain_checkpoint{"plain", 1};
/// The content of a checkpoint, FoamSim's or MultiTracker's: its checksum is always right.
Feed feed_checkpoint, feed_tracker_checkpoint;

/// A reader by its name, "ply"; its corpus lies in a folder of that name.
struct Harness {
  std::string_view name;
  Feed* feed;
};
std::span<const Harness> harnesses();

}  // namespace fuzz
