// What docs/scenes.md shows of each scene. Reference values are measured of runs of the reference program at its clock
// 0.4, which is 0.2 here.
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "FoamSim/scenes/shapes/double_bubble_equilibrium.h"
#include "FoamSim/studies/reproduce/scene_gallery.h"
#include "LosTopos/mesh/measures.h"

namespace foamsim {
namespace {

using lostopos::Region;
using std::numbers::pi;

using Measure = std::function<double(const Simulation&)>;

constexpr const char* of_reference = "reference program";
constexpr const char* of_closed_form = "closed form";

// Of the films: solids are none.
double area_of_films(const Simulation& simulation) {
  double area = 0;
  for (lostopos::Triangle t : simulation.mesh().triangles())
    if (simulation.solid()[t.index()] == 0) area += lostopos::area(simulation.mesh(), t);
  return area;
}

double volume_of(const Simulation& simulation, std::size_t region) {
  for (const auto& [r, volume] : lostopos::region_volumes(simulation.mesh()))
    if (r == Region(region)) return volume;
  return 0;
}

Measure volume(std::size_t region) {
  return [region](const Simulation& simulation) { return volume_of(simulation, region); };
}

// Over that of a ball of the same volume.
double area_over_ball(const Simulation& simulation) {
  return area_of_films(simulation) / (std::cbrt(36 * pi) * std::pow(volume_of(simulation, 1), 2.0 / 3));
}

// Over that of the standard double bubble of the same volumes.
double area_over_double_bubble(const Simulation& simulation) {
  return area_of_films(simulation) /
         double_bubble_equilibrium(volume_of(simulation, 1), volume_of(simulation, 2)).total_area();
}

double regions(const Simulation& simulation) {
  return static_cast<double>(lostopos::regions(simulation.mesh()).size()) - 1;
}

// How far the held vertices reach along x, L.
double width_of_held(const Simulation& simulation) {
  double least = std::numeric_limits<double>::infinity(), most = -least;
  for (lostopos::Vertex v : simulation.mesh().vertices()) {
    if (!lostopos::is_held(simulation.held()[v.index()])) continue;
    least = std::min(least, simulation.mesh().position(v).x());
    most = std::max(most, simulation.mesh().position(v).x());
  }
  return most - least;
}

// z of the held vertex nearest to where the sheet's rod is fixed, L.
double height_of_fixed_point(const Simulation& simulation) {
  const lostopos::Vec3 fixed(0, -0.25, std::sqrt(0.75));
  double nearest = std::numeric_limits<double>::infinity(), height = 0;
  for (lostopos::Vertex v : simulation.mesh().vertices()) {
    const double distance = (simulation.mesh().position(v) - fixed).norm();
    if (!lostopos::is_held(simulation.held()[v.index()]) || distance >= nearest) continue;
    nearest = distance;
    height = simulation.mesh().position(v).z();
  }
  return height;
}

// Of the bubble's volume, what lies at x < 0; its films cross that plane at the wire.
double share_of_left(const Simulation& simulation) {
  double left = 0, all = 0;
  for (lostopos::Triangle t : simulation.mesh().triangles()) {
    const lostopos::Vec3 centre = lostopos::barycentre(simulation.mesh(), t);
    const double cone = (simulation.mesh().labels(t).q == lostopos::air ? 1 : -1) *
                        centre.dot(lostopos::area_vector(simulation.mesh(), t)) / 3;
    all += cone;
    if (centre.x() < 0) left += cone;
  }
  return left / all;
}

double contact_of(const Simulation& simulation, std::size_t p, std::size_t q) {
  double area = 0;
  for (lostopos::Triangle t : simulation.mesh().triangles()) {
    const lostopos::Labels labels = simulation.mesh().labels(t);
    if (labels.has(Region(p)) && labels.has(Region(q))) area += lostopos::area(simulation.mesh(), t);
  }
  return area;
}

double bubbles_that_three_touches(const Simulation& simulation) {
  return (contact_of(simulation, 1, 3) > 0 ? 1 : 0) + (contact_of(simulation, 2, 3) > 0 ? 1 : 0);
}

std::vector<GalleryScene> scenes_of_bubbles() {
  return {
      {"sphere", 0.3, {}, {{"volume of the bubble", 0.3, volume(1), 1.66068, 0.01, "as at the start"}}},
      {"mode", 0.1, {"mode=4", "amplitude=0.2"}, {{"volume", 0.1, volume(1), 4.19, 0.03, "a ball's"}}},
      {"tet", 3, {}, {{"area over a ball's", 3, area_over_ball, 1, 0.03, of_closed_form}}},
      {"cube", 3, {}, {{"area over a ball's", 3, area_over_ball, 1, 0.01, of_closed_form}}},
      {"doublebubble", 4, {}, {{"area over a double bubble's", 4, area_over_double_bubble, 1, 0.02, of_closed_form}}},
      {"twobubbles", 3, {}, {{"area over a double bubble's", 3, area_over_double_bubble, 1, 0.03, of_closed_form}}},
      {"headon", 2, {}, {{"area over a double bubble's", 2, area_over_double_bubble, 1, 0.03, of_closed_form}}},
  };
}

std::vector<GalleryScene> scenes_of_junctions() {
  return {
      {"barrel", 0.2, {}, {{"area", 0.2, area_of_films, 48 * std::sin(pi / 24), 1e-10, "as at the start"}}},
      {"triplejunction", 0.2, {}, {{"area", 0.2, area_of_films, 4, 1e-10, "as at the start"}}},
      {"triplejunction-frame", 3, {}, {{"area", 3, area_of_films, 3, 0.005, of_closed_form}}},
      {"quadjunction", 0.2, {}, {{"area", 0.2, area_of_films, 8.9656, 0.003, of_reference}}},
      {"quadjunction-frame", 3, {}, {{"area", 3, area_of_films, 2 * std::numbers::sqrt2, 0.01, of_closed_form}}},
      {"octahedron", 1.5, {}, {{"area of films", 1.5, area_of_films, 4 * std::numbers::sqrt2, 0.002, of_closed_form}}},
  };
}

std::vector<GalleryScene> scenes_of_wires() {
  return {
      {"constrainedsphere",
       1,
       {},
       {{"area", 0.2, area_of_films, 9.0919, 0.003, of_reference},
        {"volume", 0.2, volume(1), 2.4911, 0.001, of_reference}},
       {-0.8, 0.3, 0.6}},
      {"bubblewand", 0.6, {}, {{"volume", 0.2, volume(1), 1.9972, 0.01, of_reference}}},
      {"tworingspinching",
       3.6,
       {},
       {{"volume", 0.2, volume(1), 0.75812, 0.005, of_reference},
        {"distance of the tips", 3, width_of_held, 2.7, 1e-10, "speed and time"}},
       {0.3, 0.3, 0.9}},
      {"peanutbubble",
       7.5,
       {"resolution=0.2"},
       {{"volume", 0.2, volume(1), 6.98670, 0.01, "as at the start"},
        {"share of the larger half", 7.5, share_of_left, 1, 0.2, "nothing stays in the smaller one"}}},
      {"straw", 1, {}, {{"volume", 0.2, volume(1), 1.6916, 0.01, of_reference}}},
      {"carousel",
       3.4,
       {},
       {{"bubbles that the third touches", 3.4, bubbles_that_three_touches, 2, 0, "the purpose of the scene"}},
       {0.3, 0.15, 0.95}},
      {"sheet",
       0.5,
       {},
       {{"height of the fixed point", 0.5, height_of_fixed_point, std::sqrt(0.75), 1e-10, "as at the start"}},
       {0.5, 0.6, 0.6}},
  };
}

std::vector<GalleryScene> scenes_of_foams() {
  return {
      {"foaminit", 0.6, {}, {{"volume of each", 0.2, volume(1), 0.5685, 0.01, of_reference}}, {0.2, 0.9, 0.4}},
      {"growth", 0.6, {}, {{"bubbles", 0.6, regions, 8, 0, "as at the start"}}},
      {"foam", 0.8, {"burst_start=0.6"}, {{"bubbles", 0.8, regions, 7, 0, "eight less one that has burst"}}},
      {"pullingfoam", 0.6, {}, {{"bubbles", 0.6, regions, 8, 0, "as at the start"}}},
  };
}

}  // namespace

std::vector<GalleryScene> gallery_scenes() {
  std::vector<GalleryScene> all;
  for (auto* part : {scenes_of_bubbles, scenes_of_junctions, scenes_of_wires, scenes_of_foams})
    for (GalleryScene& scene : part()) all.push_back(std::move(scene));
  return all;
}

}  // namespace foamsim
