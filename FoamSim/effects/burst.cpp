#include "FoamSim/effects/burst.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "Base/error.h"
#include "Base/json/checked_json.h"
#include "LosTopos/mesh/measures.h"
#include "LosTopos/mesh/region_burst.h"

namespace foamsim {

using lostopos::Region;

namespace {

std::string text_of(Region region) {
  return std::to_string(region.index());
}

// The n-th number of the sequence that belongs to a seed (splitmix64).
std::uint64_t random_number(std::uint64_t seed, std::uint64_t n) {
  std::uint64_t z = seed * 0xd1342543de82ef95ULL + (n + 1) * 0x9e3779b97f4a7c15ULL;
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ULL;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebULL;
  return z ^ (z >> 31);
}

}  // namespace

Burst::Burst(BurstSchedule schedule) : schedule_(std::move(schedule)) {
  const auto& regions = schedule_.regions;
  if (!schedule_.times.empty() && !regions.empty() && schedule_.times.size() != regions.size())
    throw base::InputError("burst_times has " + std::to_string(schedule_.times.size()) + " times and burst_region " +
                           std::to_string(regions.size()) + " regions; give one time a region, or leave one out");
  if (!std::ranges::is_sorted(schedule_.times)) throw base::InputError("burst_times have to ascend");
  for (std::size_t i = 0; i < regions.size(); ++i) {
    if (regions[i] == lostopos::air) throw base::InputError("burst_region 0 is the air, which cannot burst");
    if (std::find(regions.begin(), regions.begin() + static_cast<std::ptrdiff_t>(i), regions[i]) !=
        regions.begin() + static_cast<std::ptrdiff_t>(i))
      throw base::InputError("burst_region names region " + text_of(regions[i]) + " twice; it can burst once");
  }
}

void Burst::begin(const EffectStep& step) {
  const std::vector<Region> present = lostopos::regions(step.mesh);
  for (Region region : schedule_.regions)
    if (!std::ranges::binary_search(present, region))
      throw base::InputError("burst_region names region " + text_of(region) +
                             ", which this surface does not have; its " + "bubbles are 1 to " +
                             text_of(present.back()));
}

std::optional<double> Burst::time_of(std::size_t n) const {
  if (!schedule_.regions.empty() && n >= schedule_.regions.size()) return {};
  if (schedule_.times.empty()) return schedule_.start + static_cast<double>(n) * schedule_.interval;
  if (n >= schedule_.times.size()) return {};
  return schedule_.times[n];
}

Region Burst::choose(const EffectStep& step, std::vector<Region>& candidates) const {
  if (schedule_.regions.empty()) return candidates[random_number(schedule_.seed, done_.size()) % candidates.size()];
  const Region region = schedule_.regions[done_.size()];
  if (!std::ranges::binary_search(candidates, region))
    throw base::Error("region " + text_of(region) + " is to burst at t = " + std::to_string(step.time) +
                      ", and has no film towards the air");
  return region;
}

std::vector<Region> Burst::bursts(const EffectStep& step) {
  // Steps that begin at a time begin at its multiple of dt, to rounding.
  const auto is_due = [&] {
    const std::optional<double> due = time_of(done_.size());
    return due && step.time + 1e-9 * step.dt >= *due;
  };
  if (!is_due()) return {};
  std::vector<Region> candidates = lostopos::regions_at_air(step.mesh);
  if (schedule_.regions.empty() && candidates.size() < 2) return {};
  // One a step: the surface that the next one is chosen from is not known yet.
  const Region region = choose(step, candidates);
  done_.push_back({region, step.time});
  return {region};
}

nlohmann::json Burst::state() const {
  nlohmann::json state = nlohmann::json::array();
  for (const Done& done : done_) state.push_back({done.region.index(), done.time});
  return state;
}

void Burst::restore(const nlohmann::json& state) {
  std::vector<Done> done;
  for (const base::CheckedJson& entry : base::CheckedJson(state, "the state of effect 'burst'").entries()) {
    const auto parts = entry.entries(2);
    done.push_back({Region(parts[0].index()), parts[1].finite_number()});
  }
  done_ = std::move(done);
}

}  // namespace foamsim
