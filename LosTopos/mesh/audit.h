#pragma once

#include <optional>
#include <string>
#include <vector>

#include "LosTopos/mesh/box_walls.h"
#include "LosTopos/mesh/surface_mesh.h"

namespace lostopos {

struct AuditOptions {
  /// Also test every edge against every triangle near it (exact), and, where none meets one, for parts inside out.
  bool intersections = true;
  bool closed_regions = true;  ///< a region's boundary must be closed; false for films that end at a wire
  /// Walls of a box that films may end at: there an edge with one triangle is no opening, and nothing is known of what
  /// lies beyond, so that every region, 0 too, is an ordinary one.
  std::optional<BoxWalls> walls = {};
  std::size_t max_findings = 50;  ///< stop looking after so many
};

/// What an audit can find wrong.
enum class Defect {
  broken_incidence,     ///< the lists of vertices, edges and triangles contradict each other
  bad_labels,           ///< equal labels on both sides, or an invalid region
  duplicate_triangle,   ///< two triangles on the same three vertices
  isolated_vertex,      ///< no triangle uses it
  not_finite,           ///< a coordinate is NaN or infinite
  degenerate_triangle,  ///< its corners are on a line
  open_region,          ///< a region's boundary ends at an edge
  inconsistent_labels,  ///< neighbouring films around an edge disagree on the region between them
  inside_out,           ///< so do films that no edge joins: the region outside a bubble is not the one around it
  intersection,         ///< an edge meets a triangle it does not belong to, or two triangles lie on each other
};
const char* name(Defect defect);

struct Finding {
  Defect defect;
  std::string message;  ///< elements and positions, for a person
};

struct AuditReport {
  std::vector<Finding> findings;
  bool truncated = false;  ///< there may be more than max_findings
  bool clean() const { return findings.empty(); }
  bool has(Defect defect) const;
  /// One line a finding; "clean" when there is none.
  std::string text() const;
};

/// Checks the whole mesh: incidence, labels around every edge, duplicates, finite positions, closed regions, that the
/// surface does not intersect itself (exact predicates; contact counts as intersection), and, where all of this is so
/// and no film ends in the open, that no part of it is inside out (see region_lines.h). Read-only; cost close to
/// linear in the number of triangles for evenly sized meshes.
AuditReport audit(const SurfaceMesh& mesh, const AuditOptions& options = {});

}  // namespace lostopos
