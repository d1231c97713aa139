#pragma once

#include <array>
#include <cstdint>
#include <string>

#include "LosTopos/mesh/handles.h"
#include "LosTopos/vec3.h"

namespace lostopos {

/// What is wrong with a part of a surface that was read, to be reported with its place in the file; empty when nothing
/// is. Numbers are taken as wide as files have them.
/// @{
std::string position_problem(const Vec3& position);
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

}  // namespace lostopos
