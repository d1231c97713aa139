#include "LosTopos/remeshing/remesher.h"

#include "Base/timing/stopwatch.h"
#include "LosTopos/remeshing/remesh_pass.h"

namespace lostopos {

Remesher::Remesher(SurfaceMesh& mesh, const VertexAttribute<Hold>& held, const RemeshOptions& options,
                   std::vector<OperationObserver*> observers)
    : mesh_(mesh), held_(held), options_(options), observers_(std::move(observers)) {
  limits_of(options_);  // throws early
}

RemeshStatistics Remesher::run(NearTriangles* index) {
  const base::Stopwatch watch;
  RemeshStatistics statistics;
  RemeshContext context(mesh_, held_, options_, observers_, index);
  RemeshPass pass(context, statistics);
  auto improve = [&] {
    if (options_.collapse) pass.collapse_short_edges();
    if (options_.flip) pass.flip_edges();
    if (options_.smoothing) pass.smooth();
  };
  if (options_.split) {
    pass.split_long_edges();
    pass.split_large_angles();
  }
  improve();
  for (int round = 0; round < options_.max_aggressive_rounds && pass.has_bad_triangles(); ++round) {
    ++statistics.aggressive_rounds;
    pass.mend_bad_triangles();
    improve();
  }
  pass.count_what_is_left();
  statistics.seconds = watch.seconds();
  return statistics;
}

}  // namespace lostopos
