#pragma once

#include <array>
#include <cstdint>
#include <string>

#include "LosTopos/mesh/handles.h"
#include "LosTopos/mesh/length_range.h"

namespace lostopos {

/// What is wrong with a part of a surface that was read, to be reported with its place in the file; empty when nothing
/// is; of positions: see length_range.h. Numbers are taken as wide as files have them.
/// @{
/// `corners` count from 0; the message counts from `first_number`, as the format does.
std::string corner_problem(const std::array<std::int64_t, 3>& corners, std::uint64_t vertex_count,
                           std::int64_t first_number = 0);
std::string label_problem(std::int64_t p, std::int64_t q);
std::string vertex_count_problem(std::uint64_t count);
std::string triangle_count_problem(std::uint64_t count);
/// @}

/// The numbers as corners and labels; to be called when they have no problem.
/// @{
std::array<std::uint32_t, 3> checked_corners(const std::array<std::int64_t, 3>& corners);
Labels checked_labels(std::int64_t p, std::int64_t q);
/// @}

struct SurfaceData;

/// Throws InputError, with the triangle behind `place`, when an edge is too short to be computed with; for readers, at
/// the end.
void require_edges_in_range(const SurfaceData& data, const std::string& place = {});

}  // namespace lostopos
