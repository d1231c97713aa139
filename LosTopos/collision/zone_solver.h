#pragma once

#include <span>

#include "LosTopos/collision/contact.h"
#include "LosTopos/collision/motion.h"

namespace lostopos {

/// Changes the motions of the contacts' free vertices as little as possible (in the norm Σ m |change|²) so that every
/// contact meets its target exactly: with C the contacts' rows, M the masses and b = target − C d,
/// d += M⁻¹ Cᵀ λ, (C M⁻¹ Cᵀ + ρ) λ = b (Harmon et al. 2008, equation 4). ρ, 1e-7 of the largest diagonal term, makes
/// the matrix definite, for contacts may repeat or contradict each other; what it leaves is met when it is solved
/// again. Where there are more contacts than coordinates to change, the same change comes from (ρ M + Cᵀ C) change = Cᵀ
/// b. Up to 12 contacts are solved densely, more by one sparse factorisation (CHOLMOD). Returns false, with nothing
/// changed, when all vertices are held or the factorisation fails.
bool solve_contacts(Motion& motion, std::span<const Contact> contacts);

}  // namespace lostopos
