#include "FoamSim/statistics/foam_statistics.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <set>

#include "FoamSim/statistics/bubble_pressures.h"

namespace foamsim {

using lostopos::Region;
using lostopos::SurfaceMesh;
using lostopos::Vertex;

namespace {

// A bubble with what it has in common with others.
struct Cell {
  BubbleStatistics counted;
  std::set<std::size_t> borders;
  std::set<Vertex> vertices;
  std::set<Region> neighbours;
};

void add_film(Cell& cell, const Film& film, Region other) {
  cell.counted.area += film.area;
  if (other == lostopos::air)
    cell.counted.air_area += film.area;
  else
    cell.neighbours.insert(other);
  ++cell.counted.faces;
  cell.borders.insert(film.borders.begin(), film.borders.end());
  cell.vertices.insert(film.vertices.begin(), film.vertices.end());
}

std::map<Region, Cell> cells_of(const FilmNetwork& network) {
  std::map<Region, Cell> cells;
  for (const Film& film : network.films) {
    const auto [low, high] = film.regions;
    if (low != lostopos::air) add_film(cells[low], film, high);
    add_film(cells[high], film, low);
  }
  for (auto& [region, cell] : cells) {
    cell.counted.region = region;
    cell.counted.edges = cell.borders.size();
    for (std::size_t border : cell.borders)
      if (network.borders[border].closed) ++cell.counted.loops;
    cell.counted.vertices = cell.vertices.size();
    cell.counted.neighbours = cell.neighbours.size();
  }
  return cells;
}

template <class Items, class Value>
Spread spread_over(const Items& items, Value&& value) {
  std::vector<double> values;
  for (const auto& item : items)
    if (const std::optional<double> found = value(item)) values.push_back(*found);
  return spread_of(values);
}

}  // namespace

Spread spread_of(std::span<const double> values) {
  if (values.empty()) return {};
  const auto n = static_cast<double>(values.size());
  double sum = 0, squares = 0;
  for (double value : values) sum += value;
  const double mean = sum / n;
  for (double value : values) squares += (value - mean) * (value - mean);
  return {mean, std::sqrt(squares / n)};
}

FoamStatistics foam_statistics(const SurfaceMesh& mesh, std::span<const std::uint8_t> solid) {
  FoamStatistics foam;
  foam.network = film_network(mesh, solid);
  std::map<Region, Cell> cells = cells_of(foam.network);
  const std::map<Region, double> volumes = bubbles_of_films(mesh, solid);
  const std::map<Region, double> pressures = bubble_pressures(mesh, volumes, solid);
  for (auto& [region, cell] : cells) {
    if (const auto volume = volumes.find(region); volume != volumes.end()) cell.counted.volume = volume->second;
    if (const auto pressure = pressures.find(region); pressure != pressures.end())
      cell.counted.pressure = pressure->second;
    foam.bubbles.push_back(cell.counted);
  }
  return foam;
}

double FoamStatistics::film_area() const {
  double sum = 0;
  for (const Film& film : network.films) sum += film.area;
  return sum;
}

double FoamStatistics::border_length() const {
  double sum = 0;
  for (const PlateauBorder& border : network.borders) sum += border.length;
  return sum;
}

std::size_t FoamStatistics::inner_bubbles() const {
  return static_cast<std::size_t>(std::ranges::count_if(bubbles, [](const auto& b) { return b.air_area == 0; }));
}

Spread FoamStatistics::volumes() const {
  return spread_over(bubbles, [](const BubbleStatistics& b) { return b.volume; });
}

std::optional<double> FoamStatistics::polydispersity() const {
  double cubes = 0, squares = 0, count = 0;
  for (const BubbleStatistics& bubble : bubbles) {
    if (!bubble.volume || !(*bubble.volume > 0)) continue;
    const double radius = std::cbrt(*bubble.volume * 3 / (4 * std::numbers::pi));
    cubes += radius * radius * radius;
    squares += radius * radius;
    ++count;
  }
  if (count == 0) return std::nullopt;
  return cubes / squares / std::cbrt(cubes / count) - 1;
}

Spread FoamStatistics::faces() const {
  return spread_over(bubbles, [](const BubbleStatistics& b) { return std::optional<double>(b.faces); });
}

Spread FoamStatistics::inner_faces() const {
  return spread_over(bubbles, [](const BubbleStatistics& b) {
    return b.air_area == 0 ? std::optional<double>(b.faces) : std::nullopt;
  });
}

Spread FoamStatistics::film_edges() const {
  return spread_over(network.films, [](const Film& f) { return std::optional<double>(f.borders.size()); });
}

Spread FoamStatistics::neighbours() const {
  return spread_over(bubbles, [](const BubbleStatistics& b) { return std::optional<double>(b.neighbours); });
}

Spread FoamStatistics::pressures() const {
  return spread_over(bubbles, [](const BubbleStatistics& b) { return b.pressure; });
}

}  // namespace foamsim
