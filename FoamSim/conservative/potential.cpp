#include "FoamSim/conservative/potential.h"

#include <algorithm>
#include <cmath>

#include "Base/parallel/for_each.h"
#include "FoamSim/conservative/potential_transfer.h"
#include "FoamSim/linear/dense_solve.h"

namespace foamsim {

using lostopos::Region;
using lostopos::SurfaceMesh;
using lostopos::Vertex;

namespace {

Vertex vertex(std::size_t slot) {
  return Vertex(static_cast<std::uint32_t>(slot));
}

// The row of v's entries: where region r is in it.
std::size_t entry_of(const FilmConnectivity& films, std::size_t v, Region r) {
  const auto begin = films.regions.begin() + films.first_entry[v],
             end = films.regions.begin() + films.first_entry[v + 1];
  return static_cast<std::size_t>(std::lower_bound(begin, end, r) - films.regions.begin());
}

}  // namespace

const double* find(const VertexPotential& potential, Region r) {
  const auto it = std::ranges::lower_bound(potential, r, {}, &RegionPotential::region);
  return it != potential.end() && it->region == r ? &it->value : nullptr;
}

bool is_sound(const VertexPotential& potential) {
  const auto is_none = [](const RegionPotential& each) { return !each.region.valid() || !std::isfinite(each.value); };
  return std::ranges::none_of(potential, is_none) &&
         std::ranges::adjacent_find(potential, std::ranges::greater_equal(), &RegionPotential::region) ==
             potential.end();
}

VertexPotential interpolate(const VertexPotential& a, const VertexPotential& b, double t) {
  double level = 0;
  int common = 0;
  for (const RegionPotential& entry : a)
    if (const double* other = find(b, entry.region)) {
      level += entry.value - *other;
      ++common;
    }
  if (common > 0) level /= common;
  VertexPotential mixed = a;
  for (RegionPotential& entry : mixed)
    if (const double* other = find(b, entry.region)) entry.value = (1 - t) * entry.value + t * (*other + level);
  for (const RegionPotential& entry : b) {
    const auto it = std::ranges::lower_bound(mixed, entry.region, {}, &RegionPotential::region);
    if (it == mixed.end() || it->region != entry.region) mixed.insert(it, {entry.region, entry.value + level});
  }
  return mixed;
}

PotentialField::PotentialField(SurfaceMesh& mesh, bool conserving)
    : values_(
          mesh.add_vertex_attribute<VertexPotential>("potential", std::make_unique<PotentialTransfer>(conserving))) {}

bool PotentialField::at_rest() const {
  return std::ranges::all_of(values_.slots(), [](const VertexPotential& own) {
    return std::ranges::all_of(own, [](const RegionPotential& each) { return each.value == 0; });
  });
}

void PotentialField::gather(const FilmConnectivity& films, std::span<double> phi) const {
  base::parallel_for_each(films.vertex_slots(), film_grain, [&](std::size_t v) {
    for (std::size_t e = films.first_entry[v]; e < films.first_entry[v + 1]; ++e) {
      const double* held = find(values_[vertex(v)], films.regions[e]);
      phi[e] = held != nullptr ? *held : 0.0;
    }
  });
}

void PotentialField::scatter(const FilmConnectivity& films, std::span<const double> phi) {
  for (std::size_t v = 0; v < films.vertex_slots(); ++v) {
    VertexPotential& values = values_[vertex(v)];
    values.clear();
    for (std::size_t e = films.first_entry[v]; e < films.first_entry[v + 1]; ++e)
      values.push_back({films.regions[e], phi[e]});
  }
}

void put_circulation(const FilmConnectivity& films, std::span<const double> phi, CirculationField& circulation) {
  base::parallel_for_each(films.vertex_slots(), film_grain, [&](std::size_t v) {
    if (films.first_entry[v] == films.first_entry[v + 1]) return;
    for (PairCirculation& pair : circulation.at(vertex(v)))
      pair.value = phi[entry_of(films, v, pair.pair.low)] - phi[entry_of(films, v, pair.pair.high)];
  });
}

void take_circulation(const FilmConnectivity& films, const CirculationField& circulation, std::span<double> phi) {
  base::parallel_for_each(films.vertex_slots(), film_grain, [&](std::size_t v) {
    const std::size_t first = films.first_entry[v], count = films.first_entry[v + 1] - first;
    if (count == 0) return;
    // Normal equations of (φ^p − φ^q) = change, made definite by holding the sum of the changes at zero.
    Eigen::MatrixXd matrix = Eigen::MatrixXd::Ones(count, count);
    Eigen::VectorXd right = Eigen::VectorXd::Zero(count);
    bool changed = false;
    for (const PairCirculation& pair : circulation.at(vertex(v))) {
      const auto p = static_cast<Eigen::Index>(entry_of(films, v, pair.pair.low) - first);
      const auto q = static_cast<Eigen::Index>(entry_of(films, v, pair.pair.high) - first);
      const double change =
          pair.value - (phi[first + static_cast<std::size_t>(p)] - phi[first + static_cast<std::size_t>(q)]);
      changed = changed || change != 0;
      matrix(p, p) += 1;
      matrix(q, q) += 1;
      matrix(p, q) -= 1;
      matrix(q, p) -= 1;
      right[p] += change;
      right[q] -= change;
    }
    if (!changed) return;
    const Eigen::VectorXd change = solve_symmetric(matrix, right);
    for (std::size_t i = 0; i < count; ++i) phi[first + i] += change[static_cast<Eigen::Index>(i)];
  });
}

}  // namespace foamsim

namespace lostopos {
namespace {

struct StoredPotential {
  std::uint64_t region;
  double value;
};

using PotentialCodec = ListCodec<foamsim::VertexPotential, StoredPotential>;

}  // namespace

void AttributeCodec<foamsim::VertexPotential>::encode(std::span<const foamsim::VertexPotential> values,
                                                      std::vector<std::uint8_t>& bytes) {
  PotentialCodec::encode(values, bytes, [](const foamsim::RegionPotential& own) {
    return StoredPotential{own.region.index(), own.value};
  });
}

std::optional<std::vector<foamsim::VertexPotential>> AttributeCodec<foamsim::VertexPotential>::decode(
    std::span<const std::uint8_t> bytes) {
  auto values = PotentialCodec::decode(bytes, [](const StoredPotential& stored) {
    const bool is_region = stored.region < Region::invalid_index;
    return foamsim::RegionPotential{is_region ? Region(stored.region) : Region(), stored.value};
  });
  if (!values || !std::ranges::all_of(*values, [](const auto& own) { return foamsim::is_sound(own); })) return {};
  return values;
}

}  // namespace lostopos
