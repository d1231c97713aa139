#include "LosTopos/remeshing/surface_index.h"

namespace lostopos {

NearTriangles& SurfaceIndex::used() {
  if (!used_) {
    used_ = given_ ? given_ : &own_;
    used_->follow(mesh_, mesh_.positions(), mesh_.positions());
  }
  return *used_;
}

void SurfaceIndex::nearby(const Box& box, std::vector<Triangle>& found) {
  used().overlapping(mesh_, box, found);
}

void SurfaceIndex::near(Triangle t, double distance, std::vector<Triangle>& found) {
  if (used().margins().reach >= distance) {
    used_->complete(mesh_);
    const auto listed = used_->near(t);
    found.assign(listed.begin(), listed.end());
    return;
  }
  used_->overlapping(mesh_, triangle_box(mesh_, t, mesh_.positions(), distance), found);
}

bool SurfaceIndex::near_moving(Vertex v, const Vec3& x, double distance, std::vector<Triangle>& found) {
  found.clear();
  return used().margins().reach >= distance && used_->covers(v, x) && used_->append_around(mesh_, v, found);
}

void SurfaceIndex::changed(Triangle t) {
  if (used_) used_->changed(mesh_, t);
}

void SurfaceIndex::removed(Triangle t) {
  if (used_) used_->removed(t);
}

}  // namespace lostopos
