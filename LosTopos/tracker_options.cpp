#include "LosTopos/tracker_options.h"

#include <sstream>

#include "LosTopos/memory_limit.h"

namespace lostopos {
namespace {

constexpr const char* by_area = "area";
constexpr const char* by_flow = "flow";
constexpr long most_rounds = 1000;

base::OptionSpec separation_rule(SeparationRule rule) {
  return {"topology.separation", std::string(rule == SeparationRule::area ? by_area : by_flow),
          "films part when the area shrinks (area) or the motion diverges (flow)", "area or flow",
          [](const base::OptionValue& value) {
            const auto& word = std::get<std::string>(value);
            return word == by_area || word == by_flow;
          }};
}

void append(std::vector<base::OptionSpec>& specs, std::vector<base::OptionSpec> more) {
  for (base::OptionSpec& spec : more) specs.push_back(std::move(spec));
}

std::vector<base::OptionSpec> remeshing_specs(const TrackerOptions& d) {
  return {
      base::flag("remeshing.enabled", d.remeshing, "split, collapse, flip and smooth triangles after every step"),
      base::whole_between(1, most_rounds, d.remeshing_iterations, "remeshing.iterations", "remeshing passes a step"),
      base::positive_number("remeshing.shortest_edge", d.remesh.shortest_edge,
                            "shorter edges are collapsed, in resolutions"),
      base::positive_number("remeshing.longest_edge", d.remesh.longest_edge, "longer edges are split, in resolutions"),
      base::positive_number("remeshing.min_area", d.remesh.min_area,
                            "no smaller triangle is made, in resolutions squared"),
      base::positive_number("remeshing.min_angle", d.remesh.min_angle, "no smaller angle is made, degrees"),
      base::positive_number("remeshing.max_angle", d.remesh.max_angle, "no larger angle is made, degrees"),
      base::positive_number("remeshing.split_angle", d.remesh.split_angle,
                            "the edge opposite to a larger angle is split, degrees"),
      base::positive_number("remeshing.max_volume_change", d.remesh.max_volume_change,
                            "largest change of a volume by an operation, in resolutions cubed"),
      base::flag("remeshing.collapse_to_held", d.remesh.collapse_to_held,
                 "collapse short edges also into a held vertex; false where there are wires or rods"),
      base::flag("remeshing.smoothing", d.remesh.smoothing, "smooth badly shaped triangles along the films"),
      base::positive_number("remeshing.smooth_below", d.remesh.smooth_below_angle,
                            "triangles with a smaller angle are smoothed, degrees; 60: all"),
      base::flag("remeshing.butterfly", d.remesh.use_butterfly, "curved positions for new vertices; false: midpoints"),
  };
}

std::vector<base::OptionSpec> topology_specs(const TopologyOptions& d) {
  return {
      base::flag("topology.enabled", d.enabled, "films join, part and vanish"),
      base::flag("topology.snap", d.snap, "join surfaces that come close"),
      base::flag("topology.separate", d.separate, "T1: part regions that meet without a common film"),
      base::flag("topology.collapse_regions", d.collapse_regions, "let regions that are too small vanish"),
      base::positive_number("topology.merge_distance", d.merge_distance, "nearer surfaces are joined, in resolutions"),
      base::non_negative_number("topology.merge_edge", d.merge_edge,
                                "shorter edges are merged, in resolutions; 0: half the merge distance"),
      base::positive_number("topology.pull_apart", d.pull_apart, "distance that a separation opens, in resolutions"),
      base::positive_number("topology.smallest_region", d.smallest_region,
                            "a region that fits into a box with this diagonal vanishes, in resolutions"),
      separation_rule(d.separation),
      base::whole_between(1, most_rounds, d.max_sweeps, "topology.max_sweeps",
                          "how often a pass looks again at what it has made"),
      base::positive_number("topology.longest_motion", d.longest_motion,
                            "a longer motion is done in parts with topology between them, in resolutions"),
  };
}

// Or else what a separation opens would be merged again at once.
void require_room_to_part(const TopologyOptions& topology) {
  if (topology.merge_edge < topology.pull_apart || topology.merge_edge == 0) return;
  std::ostringstream message;
  message << "topology.merge_edge = " << topology.merge_edge
          << " would merge what separations open (topology.pull_apart = " << topology.pull_apart
          << "); give a smaller merge_edge, or a larger pull_apart";
  throw base::InputError(message.str());
}

}  // namespace

std::vector<base::OptionSpec> tracker_option_specs(const TrackerOptions& defaults) {
  std::vector<base::OptionSpec> specs{
      base::flag("tracker.collisions", defaults.collisions, "keep the films from intersecting"),
      base::non_negative_number("tracker.proximity", defaults.proximity_epsilon,
                                "films nearer than this are pushed apart, in resolutions"),
      memory_limit_spec(),
  };
  append(specs, remeshing_specs(defaults));
  append(specs, topology_specs(defaults.topology));
  return specs;
}

TrackerOptions tracker_options(const base::OptionSet& options, double bytes_of_triangle) {
  TrackerOptions tracker;
  tracker.remesh.most_triangles = triangles_within(memory_limit(options), bytes_of_triangle);
  tracker.collisions = options.flag("tracker.collisions");
  tracker.proximity_epsilon = options.number("tracker.proximity");
  tracker.remeshing = options.flag("remeshing.enabled");
  tracker.remeshing_iterations = static_cast<int>(options.whole("remeshing.iterations"));
  tracker.remesh.shortest_edge = options.number("remeshing.shortest_edge");
  tracker.remesh.longest_edge = options.number("remeshing.longest_edge");
  tracker.remesh.min_area = options.number("remeshing.min_area");
  tracker.remesh.min_angle = options.number("remeshing.min_angle");
  tracker.remesh.max_angle = options.number("remeshing.max_angle");
  tracker.remesh.split_angle = options.number("remeshing.split_angle");
  tracker.remesh.max_volume_change = options.number("remeshing.max_volume_change");
  tracker.remesh.collapse_to_held = options.flag("remeshing.collapse_to_held");
  tracker.remesh.smoothing = options.flag("remeshing.smoothing");
  tracker.remesh.smooth_below_angle = options.number("remeshing.smooth_below");
  tracker.remesh.use_butterfly = options.flag("remeshing.butterfly");
  TopologyOptions& topology = tracker.topology;
  topology.enabled = options.flag("topology.enabled");
  topology.snap = options.flag("topology.snap");
  topology.separate = options.flag("topology.separate");
  topology.collapse_regions = options.flag("topology.collapse_regions");
  topology.merge_distance = options.number("topology.merge_distance");
  topology.merge_edge = options.number("topology.merge_edge");
  topology.pull_apart = options.number("topology.pull_apart");
  require_room_to_part(topology);
  topology.smallest_region = options.number("topology.smallest_region");
  topology.separation = options.word("topology.separation") == by_area ? SeparationRule::area : SeparationRule::flow;
  topology.max_sweeps = static_cast<int>(options.whole("topology.max_sweeps"));
  topology.longest_motion = options.number("topology.longest_motion");
  return tracker;
}

}  // namespace lostopos
