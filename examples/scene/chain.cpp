// A scene of one's own: some bubbles in a row, so near that they grow together into a chain.
#include <FoamSim/app/run_program.h>
#include <LosTopos/shapes/sphere_layout.h>

namespace {

lostopos::SurfaceMesh chain(const base::OptionSet& options) {
  std::vector<lostopos::Sphere> spheres;
  for (long i = 0; i < options.whole("bubbles"); ++i)
    spheres.push_back({{(2 + options.number("gap")) * static_cast<double>(i), 0, 0}, 1.0});
  return lostopos::sphere_meshes(spheres);
}

}  // namespace

int main(int argc, char** argv) {
  auto catalogue = std::make_shared<foamsim::Catalogue>(*foamsim::built_in_catalogue());
  catalogue->scenes.add(
      {"chain",
       "bubbles of radius 1 in a row that grow until they share walls",
       {base::whole_number("bubbles", 4, 2, "how many"),
        base::positive_number("gap", 0.1, "between neighbours at the start, L")},
       {{"time", 1.0}, {"effects", std::vector<std::string>{"surface_tension", "diffusion", "growth"}}},
       chain});
  return foamsim::run_program(argc, argv, catalogue);
}
