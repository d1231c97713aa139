#pragma once

#include <span>

#include "LosTopos/collision/motion.h"

namespace lostopos {

/// Moves the zone's vertices like one rigid body: the translation and rotation that bring the starts nearest to where
/// the vertices are asked to go (least squares; Kabsch 1976). When there are held ones among them the body follows
/// those alone; when there are some that slide, it goes with their held coordinates and does not turn. A rotation that
/// is not determined, or by more than 60°, is left out. On its straight way such a body maps affinely without turning
/// inside out, so that it does not meet itself. Keeps the mean displacement of a zone without vertices that are held in
/// any coordinate.
void move_rigidly(Motion& motion, std::span<const Vertex> zone);

}  // namespace lostopos
