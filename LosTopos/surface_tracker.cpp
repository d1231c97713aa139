#include "LosTopos/surface_tracker.h"

#include <sstream>

#include "LosTopos/error.h"

namespace lostopos {

void SurfaceTracker::advance(std::span<const Vec3> predicted) {
  if (predicted.size() != mesh_.vertex_slots())
    throw MeshError("cannot move the surface: " + std::to_string(predicted.size()) + " predicted positions for " +
                    std::to_string(mesh_.vertex_slots()) + " vertex slots; there has to be one each");
  for (Vertex v : mesh_.vertices())
    if (!predicted[v.index()].allFinite()) {
      std::ostringstream message;
      message << "cannot move vertex " << v.index() << " from (" << mesh_.position(v).transpose()
              << "): its predicted position is not finite";
      throw MotionError(message.str());
    }
  for (Vertex v : mesh_.vertices()) mesh_.set_position(v, predicted[v.index()]);
}

}  // namespace lostopos
