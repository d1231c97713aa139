#include "FoamSim/sheet/velocity/registry.h"

#include "FoamSim/sheet/velocity/direct.h"
#include "FoamSim/sheet/velocity/tree/chebyshev.h"
#include "FoamSim/sheet/velocity/tree/tree.h"

namespace foamsim {

namespace {

std::vector<base::OptionSpec> tree_options() {
  constexpr long most_order = most_nodes - 1;
  const auto is_tolerance = [](const base::OptionValue& value) {
    const double tolerance = std::get<double>(value);
    return tolerance >= least_tolerance && tolerance <= most_tolerance;
  };
  const auto is_order = [](const base::OptionValue& value) {
    const long order = std::get<long>(value);
    return order >= 0 && order <= most_order;
  };
  return {{"tolerance", 1e-4, "largest error of sums by tree over the largest value", "a number from 1e-8 to 1e-2",
           is_tolerance},
          {"order", 0L, "degree of their interpolants; 0: what the tolerance asks for",
           "a whole number from 0 to " + std::to_string(most_order), is_order}};
}

std::unique_ptr<BiotSavart> make_tree(const VelocitySetup& setup, bool direct_where_few) {
  return std::make_unique<TreeBiotSavart>(TreeOptions{.tolerance = setup.options.number("tolerance"),
                                                      .order = static_cast<std::size_t>(setup.options.whole("order")),
                                                      .direct_where_few = direct_where_few},
                                          setup.ranks);
}

}  // namespace

const base::Registry<VelocityEntry>& velocity_sums() {
  static const base::Registry<VelocityEntry> sums(
      "velocity sum",
      {{"direct",
        "every source for every target, exact to rounding; cost grows with the square of the triangles",
        {},
        [](const VelocitySetup& setup) -> std::unique_ptr<BiotSavart> {
          return std::make_unique<DirectBiotSavart>(setup.ranks);
        }},
       {"tree", "clusters of sources for clusters of targets, to a tolerance; cost grows with the triangles",
        tree_options(), [](const VelocitySetup& setup) { return make_tree(setup, false); }},
       {"auto",
        "direct where that is faster: at a tolerance of 1e-4 up to " + std::to_string(few_for_velocities({})) +
            " triangles, with conservative dynamics up to " + std::to_string(few_for_pairs({})) +
            "; from there on by tree",
        {},
        [](const VelocitySetup& setup) { return make_tree(setup, true); }}});
  return sums;
}

std::unique_ptr<BiotSavart> make_biot_savart(std::string_view name) {
  const VelocityEntry& entry = velocity_sums().find(name);
  std::vector<base::OptionSpec> specs;  // of all, for automatic ones read those of others
  for (const VelocityEntry& each : velocity_sums()) specs.insert(specs.end(), each.options.begin(), each.options.end());
  const base::OptionSet defaults(std::move(specs));
  return entry.make({defaults});
}

}  // namespace foamsim
