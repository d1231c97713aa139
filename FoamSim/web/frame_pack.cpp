#include "FoamSim/web/frame_pack.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <nlohmann/json.hpp>

#include "FoamSim/web/array_pack.h"
#include "LosTopos/io/film_faces.h"

namespace foamsim::web {

using lostopos::SurfaceData;
using lostopos::Vec3;
using nlohmann::ordered_json;

namespace {

constexpr std::uint16_t no_number = 65535;

ordered_json number_or_null(double value) {
  return std::isfinite(value) ? ordered_json(value) : ordered_json(nullptr);
}

// Head and arrays of a frame while they are put together.
class Packed {
 public:
  Packed() : head(ordered_json::object()) {}
  Packed(const Packed&) = delete;
  Packed& operator=(const Packed&) = delete;
  ~Packed() = default;

  ordered_json head;

  template <class Number>
  void add(const std::string& name, std::span<const Number> numbers, std::size_t components, bool as_differences) {
    const char* const type = sizeof(Number) == 1 ? "u8" : sizeof(Number) == 2 ? "u16" : "u32";
    describe(name, std::is_floating_point_v<Number> ? "f32" : type, numbers.size() / components, components,
             as_differences);
    if constexpr (std::is_integral_v<Number>)
      if (as_differences) {
        append_planes<Number>(arrays_, differences(numbers, components));
        return;
      }
    append_planes(arrays_, numbers);
  }

  std::string text() const {
    std::string json = head.dump(-1, ' ', false, ordered_json::error_handler_t::replace);
    const auto length = static_cast<std::uint32_t>(json.size());
    std::string result = "FSF1";
    append_planes<std::uint32_t>(result, std::span(&length, 1));
    return result + json + arrays_;
  }

 private:
  void describe(const std::string& name, const char* type, std::size_t count, std::size_t components, bool differ) {
    head["arrays"].push_back(
        {{"name", name}, {"type", type}, {"count", count}, {"components", components}, {"differences", differ}});
  }

  std::string arrays_;
};

std::uint16_t quantised(double value, double low, double high) {
  if (!std::isfinite(value)) return no_number;
  const double share = high > low ? (value - low) / (high - low) : 0;
  return static_cast<std::uint16_t>(std::lround(std::clamp(share, 0.0, 1.0) * (no_number - 1)));
}

void add_positions(const SurfaceData& surface, Precision precision, Packed& packed) {
  Vec3 low = Vec3::Zero(), high = Vec3::Zero();
  if (!surface.positions.empty()) low = high = surface.positions.front();
  for (const Vec3& x : surface.positions) {
    low = low.cwiseMin(x);
    high = high.cwiseMax(x);
  }
  packed.head["box"] = {{low[0], low[1], low[2]}, {high[0], high[1], high[2]}};
  std::vector<std::uint16_t> steps;
  std::vector<float> numbers;
  for (const Vec3& x : surface.positions)
    for (Eigen::Index k = 0; k < 3; ++k)
      if (precision == Precision::quantised)
        steps.push_back(quantised(x[k], low[k], high[k]));
      else
        numbers.push_back(static_cast<float>(x[k]));
  if (precision == Precision::quantised)
    packed.add<std::uint16_t>("positions", steps, 3, true);
  else
    packed.add<float>("positions", numbers, 3, false);
}

void add_films(const SurfaceData& surface, const SurfaceMeasures& measures, Packed& packed) {
  std::vector<std::uint32_t> corners, pair_numbers, borders;
  std::map<std::array<std::uint32_t, 2>, std::uint32_t> numbers;
  ordered_json pairs = ordered_json::array();
  for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
    for (std::uint32_t v : surface.triangles[t]) corners.push_back(v);
    const std::uint32_t p = surface.labels[t].p.index(), q = surface.labels[t].q.index();
    const auto [entry, fresh] = numbers.try_emplace({p, q}, static_cast<std::uint32_t>(numbers.size()));
    if (fresh) pairs.push_back({p, q});
    pair_numbers.push_back(entry->second);
  }
  packed.head["pairs"] = std::move(pairs);
  packed.add<std::uint32_t>("triangles", corners, 3, true);
  packed.add<std::uint32_t>("pair", pair_numbers, 1, true);
  const std::vector<std::uint8_t> solid = lostopos::solid_triangles(surface);
  if (std::ranges::any_of(solid, [](std::uint8_t s) { return s != 0; }))
    packed.add<std::uint8_t>("solid", solid, 1, false);
  for (const auto& edge : measures.borders) borders.insert(borders.end(), edge.begin(), edge.end());
  packed.add<std::uint32_t>("borders", borders, 2, true);
}

void add_field(const FrameField& field, Precision precision, Packed& packed) {
  std::vector<double> sorted;
  for (double value : field.values)
    if (std::isfinite(value)) sorted.push_back(value);
  std::ranges::sort(sorted);
  const double nothing = std::numeric_limits<double>::quiet_NaN();
  const auto at_share = [&](double share) {
    return sorted.empty() ? nothing : sorted[static_cast<std::size_t>(share * static_cast<double>(sorted.size() - 1))];
  };
  const double low = at_share(0), high = at_share(1);
  packed.head["fields"].push_back({{"name", field.name},
                                   {"on", field.on_vertices ? "vertices" : "triangles"},
                                   {"range", {number_or_null(low), number_or_null(high)}},
                                   {"usual", {number_or_null(at_share(0.02)), number_or_null(at_share(0.98))}}});
  if (precision == Precision::quantised) {
    std::vector<std::uint16_t> steps;
    for (double value : field.values) steps.push_back(quantised(value, low, high));
    packed.add<std::uint16_t>("field/" + field.name, steps, 1, true);
    return;
  }
  std::vector<float> numbers;
  for (double value : field.values) numbers.push_back(static_cast<float>(value));
  packed.add<float>("field/" + field.name, numbers, 1, false);
}

ordered_json bubbles_list(const std::vector<BubbleMeasures>& bubbles) {
  ordered_json list = ordered_json::array();
  for (const BubbleMeasures& b : bubbles)
    list.push_back({b.region, number_or_null(b.volume), b.area, number_or_null(b.pressure), b.faces, b.centre[0],
                    b.centre[1], b.centre[2]});
  return list;
}

}  // namespace

std::string pack_frame(const SurfaceData& surface, const SurfaceMeasures& measures,
                       const std::vector<FrameField>& fields, long step, double time, Precision precision) {
  Packed packed;
  packed.head["step"] = step;
  packed.head["time"] = time;
  packed.head["precision"] = precision == Precision::quantised ? "quantised" : "single";
  packed.head["fields"] = ordered_json::array();
  packed.head["bubbles"] = bubbles_list(measures.bubbles);
  add_positions(surface, precision, packed);
  add_films(surface, measures, packed);
  for (const FrameField& field : fields) add_field(field, precision, packed);
  return packed.text();
}

std::string bubbles_json(const std::vector<BubbleMeasures>& bubbles) {
  return bubbles_list(bubbles).dump();
}

}  // namespace foamsim::web
