#include "tests/support/checkpoint_damage.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "Base/error.h"
#include "LosTopos/mesh/audit.h"
#include "LosTopos/run/sealed_bytes.h"

namespace test {

using nlohmann::json;

namespace {

// Of a list the first ones stand for the others.
constexpr std::size_t entries_of_a_list = 2;

void collect(const json& value, const json::json_pointer& where, std::vector<json::json_pointer>& all) {
  all.push_back(where);
  if (value.is_object())
    for (const auto& entry : value.items()) collect(entry.value(), where / entry.key(), all);
  if (value.is_array())
    for (std::size_t i = 0; i < std::min(value.size(), entries_of_a_list); ++i) collect(value[i], where / i, all);
}

std::vector<json> strangers_for_an_option() {
  return {nullptr, -1, std::nan(""), "x"};
}

std::vector<json> strangers_for(const json& value) {
  std::vector<json> all{nullptr, true,         -1,    json::array(), json::object(),
                        "x",     std::nan(""), 1e300, -1e300,        ~std::uint64_t{0},
                        1e-300,  0.5,          0};
  if (value.is_binary()) {
    const auto& bytes = value.get_binary();
    all.push_back(json::binary({}));
    all.push_back(
        json::binary(std::vector<std::uint8_t>(bytes.begin(), bytes.begin() + static_cast<long>(bytes.size() / 2))));
    all.push_back(json::binary(std::vector<std::uint8_t>(bytes.size(), 0xff)));
    all.push_back(json::binary(std::vector<std::uint8_t>(bytes.size(), 0)));
    all.push_back(json::binary(std::vector<std::uint8_t>(bytes.size(), 1)));
    std::vector<std::uint8_t> turned(bytes.rbegin(), bytes.rend());
    all.push_back(json::binary(std::move(turned)));
  }
  if (value.is_array() && !value.empty()) {
    json longer = value;
    longer.push_back(value.front());
    all.push_back(longer);
    json shorter = value;
    shorter.erase(shorter.begin());
    all.push_back(shorter);
  }
  return all;
}

void turn_over(std::vector<std::uint8_t>& bytes, std::uint64_t bit) {
  bytes[bit / 8] = static_cast<std::uint8_t>(bytes[bit / 8] ^ (1U << (bit % 8)));
}

}  // namespace

DamagedCheckpoints::DamagedCheckpoints(const lostopos::run::Motion& motion, lostopos::run::CheckpointFormat format,
                                       Resume resume)
    : format_(std::move(format)), resume_(std::move(resume)) {
  motion.save(content_);
  EXPECT_FALSE(refused(lostopos::run::checkpoint_bytes(format_, content_), "whole"));
}

bool DamagedCheckpoints::refused(const Bytes& bytes, const std::string& what, Then then) const {
  std::unique_ptr<lostopos::run::Motion> motion;
  try {
    lostopos::run::take_checkpoint(bytes, "x.cbor", format_, [&](const json& content) { motion = resume_(content); });
  } catch (const base::InputError& error) {
    EXPECT_TRUE(std::string(error.what()).starts_with("x.cbor is not a whole checkpoint: ")) << error.what();
    return true;
  }
  using lostopos::Defect;
  const auto report = lostopos::audit(motion->mesh(), {.intersections = false, .closed_regions = false});
  for (Defect defect : {Defect::broken_incidence, Defect::not_finite, Defect::bad_labels})
    EXPECT_FALSE(report.has(defect)) << what << ": " << report.text();
  if (then == Then::end) return false;
  try {
    motion->step();
  } catch (const base::Error&) {  // NOLINT(bugprone-empty-catch): it says what it cannot do
  }
  return false;
}

void DamagedCheckpoints::expect_survived(const Bytes& bytes, const std::string& what, Then then) const {
  EXPECT_NO_THROW((void)refused(bytes, what, then)) << what;
}

void DamagedCheckpoints::expect_flips_refused(int count, std::uint64_t seed) const {
  std::mt19937_64 random(seed);
  const Bytes whole = lostopos::run::checkpoint_bytes(format_, content_);
  for (int i = 0; i < count; ++i) {
    const std::uint64_t bit = random() % (8 * whole.size());
    Bytes damaged = whole;
    turn_over(damaged, bit);
    EXPECT_TRUE(refused(damaged, "bit " + std::to_string(bit))) << "bit " << bit;
  }
}

void DamagedCheckpoints::expect_hidden_flips_survived(int count, std::uint64_t seed) const {
  std::mt19937_64 random(seed);
  const Bytes file = lostopos::run::checkpoint_bytes(format_, content_);
  const auto content = lostopos::run::unsealed(file);
  for (int i = 0; i < count; ++i) {
    const std::uint64_t bit = random() % (8 * content.size());
    Bytes damaged(content.begin(), content.end());
    turn_over(damaged, bit);
    expect_survived(lostopos::run::sealed(damaged), "bit " + std::to_string(bit) + " of the content", Then::step);
  }
}

void DamagedCheckpoints::expect_replacements_survived() const {
  std::vector<json::json_pointer> places;
  collect(content_, json::json_pointer(), places);
  for (const auto& place : places) {
    const json& value = content_.at(place);
    const Then then = place.to_string().starts_with("/options") ? Then::end : Then::step;
    for (const json& stranger : then == Then::end ? strangers_for_an_option() : strangers_for(value)) {
      json damaged = content_;
      damaged.at(place) = stranger;
      if (!damaged.is_object()) continue;
      expect_survived(lostopos::run::checkpoint_bytes(format_, damaged),
                      place.to_string() + " = " + (stranger.is_binary() ? "other bytes" : stranger.dump()), then);
    }
    if (place.empty()) continue;
    json damaged = content_;
    if (damaged.at(place.parent_pointer()).is_object()) damaged.at(place.parent_pointer()).erase(place.back());
    expect_survived(lostopos::run::checkpoint_bytes(format_, damaged), place.to_string() + " left out", then);
  }
}

}  // namespace test
