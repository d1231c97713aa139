#include "LosTopos/run/proportion.h"

#include "Base/error.h"
#include "Base/options/option_value.h"
#include "LosTopos/mesh/measures.h"

namespace lostopos::run {

void require_proportion(const SurfaceMesh& mesh, double resolution, bool remeshing) {
  constexpr double largest_ratio = 1000;
  const auto refuse = [resolution](const char* which, double length) {
    throw base::InputError(std::string("the surface has ") + which + base::to_text(length) +
                           ", out of all proportion to its resolution, " + base::to_text(resolution));
  };
  if (mesh.triangle_count() == 0) return;
  double longest = 0;
  for (Edge e : mesh.edges()) longest = std::max(longest, length(mesh, e));
  if (remeshing && !(longest < largest_ratio * resolution)) refuse("an edge of the length ", longest);
  const double mean = mean_edge_length(mesh);
  if (!(resolution < largest_ratio * mean)) refuse("edges of the mean length ", mean);
}

}  // namespace lostopos::run
