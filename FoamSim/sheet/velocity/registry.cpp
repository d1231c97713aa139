#include "FoamSim/sheet/velocity/registry.h"

#include "FoamSim/sheet/velocity/direct.h"
#include "FoamSim/sheet/velocity/tree/chebyshev.h"
#include "FoamSim/sheet/velocity/tree/tree.h"

namespace foamsim {

namespace {

// Not calibrated: at a tolerance of 1e-4 and 9,700 triangles the tree is the faster one for the vortex sheet, at 11,000
// it is still a tenth slower for the conservative dynamics, whose direct sums visit each pair once.
constexpr std::size_t few_triangles = 6000;

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

std::unique_ptr<BiotSavart> make_tree(const VelocitySetup& setup, std::size_t direct_up_to) {
  return std::make_unique<TreeBiotSavart>(TreeOptions{.tolerance = setup.options.number("tolerance"),
                                                      .order = static_cast<std::size_t>(setup.options.whole("order")),
                                                      .direct_up_to = direct_up_to});
}

}  // namespace

const base::Registry<VelocityEntry>& velocity_sums() {
  static const base::Registry<VelocityEntry> sums(
      "velocity sum",
      {{"direct",
        "every source for every target, exact to rounding; cost grows with the square of the triangles",
        {},
        [](const VelocitySetup&) -> std::unique_ptr<BiotSavart> { return std::make_unique<DirectBiotSavart>(); }},
       {"tree", "clusters of sources for clusters of targets, to a tolerance; cost grows with the triangles",
        tree_options(), [](const VelocitySetup& setup) { return make_tree(setup, 0); }},
       {"auto",
        "direct up to " + std::to_string(few_triangles) + " triangles, from there on by tree",
        {},
        [](const VelocitySetup& setup) { return make_tree(setup, few_triangles); }}});
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
