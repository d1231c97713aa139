#include "LosTopos/io/repair/repair_surface.h"

#include <algorithm>

#include "LosTopos/io/repair/repairs.h"
#include "LosTopos/io/tidy_surface.h"
#include "LosTopos/mesh/audit.h"

namespace lostopos {
namespace {

double extent_of(const SurfaceData& data) {
  if (data.positions.empty()) return 0;
  Vec3 low = data.positions.front(), high = low;
  for (const Vec3& x : data.positions) {
    low = low.cwiseMin(x);
    high = high.cwiseMax(x);
  }
  return (high - low).stableNorm();
}

std::string counted(std::size_t count, const char* one, const char* many) {
  return std::to_string(count) + " " + (count == 1 ? one : many);
}

// Why a repair leaves such a defect, and what would help.
const char* help_for(Defect defect) {
  switch (defect) {
    case Defect::open_region:
      return "the surface has a hole or a free edge there; close it where it was made, or hold it as at a frame";
    case Defect::intersection:
      return "surfaces pass through or lie on each other; move them apart where they were made";
    case Defect::inconsistent_labels:
      return "the films' regions contradict each other, whichever way they are turned; give them other regions";
    case Defect::inside_out:
      return "no turning of whole bubbles makes their regions agree; give them other regions";
    case Defect::duplicate_triangle:
      return "the two name regions that do not go together; take one of them away";
    case Defect::degenerate_triangle:
      return "its neighbours are on the same line; take the corner away";
    default:
      return "this is not mended here";
  }
}

void look_at_what_is_left(const SurfaceData& data, RepairReport& report) {
  const AuditReport audited = audit(to_mesh(data));
  for (const Finding& finding : audited.findings)
    report.left.push_back(std::string(name(finding.defect)) + ": " + finding.message + " (" + help_for(finding.defect) +
                          ")");
  if (audited.truncated) report.left.emplace_back("and more of these");
}

}  // namespace

RepairReport repair_surface(SurfaceData& data, const RepairOptions& options) {
  RepairReport report;
  if (const std::size_t merged = merge_vertices(data, options.tolerance * extent_of(data)); merged > 0)
    report.done.push_back(counted(merged, "vertex was", "vertices were") +
                          " at the place of another, and became one with it");
  if (const std::size_t dropped = drop_collapsed_triangles(data); dropped > 0)
    report.done.push_back(counted(dropped, "triangle", "triangles") + " between these vanished");
  if (const std::size_t flat = remove_flat_triangles(data); flat > 0)
    report.done.push_back(counted(flat, "triangle", "triangles") +
                          " without area went; what is beyond its longest edge was split");
  if (const std::size_t repeated = merge_repeated_triangles(data); repeated > 0)
    report.done.push_back(counted(repeated, "triangle", "triangles") + " on the corners of another went");
  const bool may_turn = data.pair_arrays.empty();
  if (const std::size_t turned = may_turn ? orient_films(data) : 0; turned > 0)
    report.done.push_back(counted(turned, "triangle was", "triangles were") +
                          " wound against the film or the junction it belongs to, and turned");
  for (std::string& note : tidy_surface(data)) report.done.push_back(std::move(note));
  if (const std::size_t turned = may_turn ? orient_bubbles(data) : 0; turned > 0)
    report.done.push_back(counted(turned, "bubble was", "bubbles were") + " inside out, and turned");
  look_at_what_is_left(data, report);
  return report;
}

}  // namespace lostopos
