#pragma once

#include <span>

#include "LosTopos/collision/contact.h"
#include "LosTopos/collision/motion.h"

namespace lostopos {

/// normal · Σ weights[i] d_i, L: what the contact's target is compared with.
double relative_displacement(const Motion& motion, const Contact& contact);

/// Meets every contact's target that is missed, one after the other, earliest first, by an impulse along its normal on
/// its four vertices: with masses m_i, d_i += weights[i] / m_i · j · normal, j = (target − r) / Σ weights² / m (Bridson
/// et al. 2002, section 7). Held vertices take none; a contact between held ones is left. Returns how many there were.
std::size_t apply_impulses(Motion& motion, std::span<const Contact> contacts);

}  // namespace lostopos
