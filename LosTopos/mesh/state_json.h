#pragma once

#include <nlohmann/json_fwd.hpp>

#include "LosTopos/mesh/surface_mesh.h"

namespace lostopos {

/// A mesh's state as binary arrays by name, in the machine's byte order; named attributes as {type, count, bytes} under
/// their names. For binary formats (CBOR) and machines of one kind.
nlohmann::json to_json(const SurfaceMesh::State& state);

/// The state back, to the bit. Attributes keep the bytes as they are, until one of the name decodes them. Throws
/// base::InputError for anything that is not such a value, MeshError for a state that SurfaceMesh::from_state refuses.
SurfaceMesh::State mesh_state_from_json(const nlohmann::json& value);

}  // namespace lostopos
