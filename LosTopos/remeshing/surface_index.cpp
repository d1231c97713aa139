#include "LosTopos/remeshing/surface_index.h"

namespace lostopos {

void SurfaceIndex::nearby(const Box& box, std::vector<Triangle>& found) {
  if (!used_) {
    own_.build(mesh_, mesh_.positions(), mesh_.positions(), 0);
    used_ = &own_;
  }
  found.clear();
  used_->query(box, found);
}

void SurfaceIndex::changed(Triangle t) {
  if (used_) used_->set(t, triangle_box(mesh_, t, mesh_.positions(), 0));
}

void SurfaceIndex::removed(Triangle t) {
  if (used_) used_->remove(t);
}

}  // namespace lostopos
