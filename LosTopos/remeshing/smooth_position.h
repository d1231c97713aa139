#pragma once

#include <optional>

#include "LosTopos/mesh/surface_mesh.h"

namespace lostopos {

/// Where modified-butterfly subdivision (Zorin, Schröder, Sweldens 1996) puts the vertex in the middle of e; nothing
/// when an end of e is not within a film (the scheme needs the whole fan of triangles around it), or when the position
/// is further than a quarter of e's length from the midpoint.
std::optional<Vec3> butterfly_position(const SurfaceMesh& mesh, Edge e);

/// The middle of border edge e on the cubic through its ends and the border's next vertices beyond them, parametrised
/// by the lengths of the chords; the parabola where the border goes on from one end only. On a circle the error is of
/// fourth order in the chord. Nothing when it goes on from neither end, or when the position is further than a quarter
/// of e's length from the midpoint.
std::optional<Vec3> border_position(const SurfaceMesh& mesh, Edge e);

}  // namespace lostopos
