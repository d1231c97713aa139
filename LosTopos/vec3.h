#pragma once

#include <Eigen/Core>

namespace lostopos {

/// A point or vector in space, in the scene's unit of length unless a docstring says otherwise.
using Vec3 = Eigen::Vector3d;

}  // namespace lostopos
