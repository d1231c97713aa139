// Checkpoints that are not what the program wrote, whether by accident or on purpose.
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "FoamSim/run/scene_motion.h"
#include "tests/support/checkpoint_damage.h"

namespace foamsim {
namespace {

using ::test::DamagedCheckpoints;

struct Sample {
  const char* name;
  const char* scene;
  std::vector<const char*> options;
};

void PrintTo(const Sample& sample, std::ostream* out) {  // NOLINT(readability-identifier-naming): GoogleTest's name
  *out << sample.name;
}

SceneMotion::Beginning beginning_of(const Sample& sample) {
  Scene scene = built_in_scene(sample.scene);
  for (const char* option : sample.options) scene.options.set_assignment(option, "test");
  return SceneMotion::beginning_of(scene);
}

std::unique_ptr<SceneMotion> resumed(const nlohmann::json& content) {
  return std::make_unique<SceneMotion>(SceneMotion::beginning_of(checkpoint_from(content, built_in_catalogue())));
}

DamagedCheckpoints damaged(const Sample& sample, int steps = 2) {
  SceneMotion motion(beginning_of(sample));
  for (int i = 0; i < steps; ++i) motion.step();
  return {motion, checkpoint_format(), resumed};
}

class DamagedCheckpointTest : public testing::TestWithParam<Sample> {};

TEST_P(DamagedCheckpointTest, WithABitTurnedOverIsRefused) {
  damaged(GetParam()).expect_flips_refused(300, 15);
}

TEST_P(DamagedCheckpointTest, WithABitTurnedOverBehindTheChecksumIsRefusedOrGoesOn) {
  damaged(GetParam()).expect_hidden_flips_survived(200, 16);
}

TEST_P(DamagedCheckpointTest, WithStrangeValuesIsRefusedOrGoesOn) {
  damaged(GetParam()).expect_replacements_survived();
}

INSTANTIATE_TEST_SUITE_P(
    Kinds, DamagedCheckpointTest,
    testing::Values(Sample{"vortex_sheet", "doublebubble", {"n=8", "topology.enabled=true"}},
                    Sample{"conservative", "doublebubble", {"n=8", "dynamics=conservative"}},
                    Sample{"wire", "tworingspinching", {"n=12", "resolution=0.4", "wires=held: pull 0.05"}},
                    Sample{"rod", "sheet", {"n=1", "dynamics=conservative"}},
                    Sample{"burst", "doublebubble", {"n=8", "effects+=burst,volumes", "burst_start=0.01"}}),
    [](const auto& info) { return std::string(info.param.name); });

// The message of what reading the changed content of a checkpoint ends in; empty: it goes on.
std::string refusal(const Sample& sample, const std::function<void(nlohmann::json&)>& change) {
  SceneMotion motion(beginning_of(sample));
  motion.step();
  nlohmann::json content;
  motion.save(content);
  change(content);
  try {
    lostopos::run::take_checkpoint(lostopos::run::checkpoint_bytes(checkpoint_format(), content), "x.cbor",
                                   checkpoint_format(), [](const nlohmann::json& c) { (void)resumed(c); });
  } catch (const base::InputError& error) {
    return error.what();
  }
  return "";
}

void expect_refusal(const Sample& sample, const std::string& part, const std::function<void(nlohmann::json&)>& change) {
  const std::string message = refusal(sample, change);
  EXPECT_NE(message.find(part), std::string::npos) << "'" << part << "' is not in '" << message << "'";
}

// Writes number `index` of a value's bytes anew.
template <class T>
void put(nlohmann::json& blob, std::size_t index, T number) {
  std::vector<std::uint8_t> bytes = blob.get_binary();
  std::memcpy(bytes.data() + index * sizeof(T), &number, sizeof(T));
  blob = nlohmann::json::binary(std::move(bytes));
}

const Sample sheet{"vortex_sheet", "doublebubble", {"n=8"}};
const Sample films{"conservative", "doublebubble", {"n=8", "dynamics=conservative"}};
const Sample wire{"wire", "tworingspinching", {"n=12", "resolution=0.4", "wires=held: pull 0.05"}};
const Sample rod{"rod", "sheet", {"n=1"}};

TEST(CheckpointOptions, AreCheckedLikeThoseOfAFile) {
  const auto set = [](const char* key, const nlohmann::json& value) {
    return [=](nlohmann::json& c) { c["options"]["values"][key] = value; };
  };
  expect_refusal(sheet, "damping = nan is not allowed", set("damping", std::nan("")));
  expect_refusal(sheet, "metrics_every = 0 is not allowed", set("metrics_every", 0));
  expect_refusal(sheet, "unknown", set("dynamics", "vortex-shet"));
  expect_refusal(sheet, "option 'colour'", set("colour", 1));
  expect_refusal(sheet, "option 'viscosity' belongs to the dynamics 'conservative'",
                 [](nlohmann::json& c) { c["options"]["set"].push_back("viscosity"); });
  expect_refusal(sheet, "is not the dt of its options", set("dt", 0.02));
  expect_refusal(sheet, "is not that of its options", set("resolution", 0.3));
  expect_refusal(sheet, "out of all proportion to its resolution, 1e-09",
                 [](nlohmann::json& c) { c["resolution"] = 1e-9; });
}

// An option that was set to what its default would not be is still set behind a checkpoint: others fill in for those
// that are not.
TEST(CheckpointOptions, ThatWereSetStaySet) {
  const Sample own{
      "set", "doublebubble", {"n=8", "dynamics=conservative", "effects=surface_tension", "remeshing.longest_edge=1.6"}};
  SceneMotion whole(beginning_of(own)), first(beginning_of(own));
  for (int i = 0; i < 4; ++i) whole.step();
  for (int i = 0; i < 2; ++i) first.step();
  nlohmann::json content;
  first.save(content);
  const auto second = resumed(content);
  for (int i = 0; i < 2; ++i) second->step();
  nlohmann::json at_end, at_end_of_whole;
  second->save(at_end);
  whole.save(at_end_of_whole);
  EXPECT_EQ(nlohmann::json::to_cbor(at_end), nlohmann::json::to_cbor(at_end_of_whole));
}

TEST(CheckpointState, HasNumbersThatAStateHas) {
  expect_refusal(sheet, "state.steps is not from 0", [](nlohmann::json& c) { c["state"]["steps"] = -1; });
  expect_refusal(sheet, "state.dt is not > 0", [](nlohmann::json& c) { c["state"]["dt"] = 0.0; });
  expect_refusal(sheet, "last.kinetic_energy is not finite",
                 [](nlohmann::json& c) { c["last"]["kinetic_energy"] = std::nan(""); });
  expect_refusal(sheet, "start_centroid is not a list of 3",
                 [](nlohmann::json& c) { c["start_centroid"].push_back(1); });
  expect_refusal(films, "the state of effect 'volumes' is not finite",
                 [](nlohmann::json& c) { c["state"]["models"]["effects"]["volumes"][0][1] = std::nan(""); });
  expect_refusal(films, "the state of the conservative dynamics.kept is not a list of 7",
                 [](nlohmann::json& c) { c["state"]["models"]["dynamics"]["kept"].push_back(0.0); });
  expect_refusal(films, "the state of the conservative dynamics has no 'about'",
                 [](nlohmann::json& c) { c["state"]["models"]["dynamics"].erase("about"); });
}

nlohmann::json& attribute(nlohmann::json& content, const char* name) {
  return content["state"]["surface"]["vertex_attributes"][name]["bytes"];
}

// std::out_of_range or worse each, once.
TEST(CheckpointState, HasAttributesThatFitTheSurfaceAndTheModels) {
  expect_refusal(sheet, "attribute 'circulation'", [](nlohmann::json& c) {
    auto& bytes = attribute(c, "circulation");
    put(bytes, bytes.get_binary().size() / 8 - 1, std::nan(""));
  });
  expect_refusal(sheet, "has the circulation of other films than those that meet there", [](nlohmann::json& c) {
    auto& bytes = attribute(c, "circulation");
    put<std::uint32_t>(bytes, bytes.get_binary().size() / 4 - 3, 7);
  });
  expect_refusal(films, "attribute 'potential'", [](nlohmann::json& c) {
    auto& bytes = attribute(c, "potential");
    put(bytes, bytes.get_binary().size() / 8 - 1, std::nan(""));
  });
  expect_refusal(wire, "attribute 'hold'", [](nlohmann::json& c) { put<std::uint8_t>(attribute(c, "hold"), 0, 200); });
  expect_refusal(wire, "is on wire path 99, and there are 1 wires",
                 [](nlohmann::json& c) { put<std::int32_t>(attribute(c, "wire"), 0, 99); });
  expect_refusal(rod, "of the rod, which has none such",
                 [](nlohmann::json& c) { put<std::int32_t>(attribute(c, "rod"), 0, -5); });
  expect_refusal(rod, "the state of constraint 'rod'.lengths is not a list of",
                 [](nlohmann::json& c) { c["state"]["models"]["constraints"]["rod"]["lengths"].push_back(1.0); });
  expect_refusal(rod, "the state of constraint 'rod' has no 'fixed'",
                 [](nlohmann::json& c) { c["state"]["models"]["constraints"].erase("rod"); });
  expect_refusal(rod, "the rod's vertices are not a chain", [](nlohmann::json& c) {
    auto& bytes = attribute(c, "rod");
    for (std::size_t i = 0; i < bytes.get_binary().size() / 4; ++i) put<std::int32_t>(bytes, i, i == 0 ? 2 : 0);
  });
}

// What carries it through remeshing wrote behind its arrays once.
TEST(CheckpointState, MayHaveThePotentialOfOtherRegionsThanMeet) {
  EXPECT_EQ(refusal(films,
                    [](nlohmann::json& c) {
                      auto& bytes = attribute(c, "potential");
                      const std::size_t words = bytes.get_binary().size() / 8;
                      std::vector<std::uint64_t> all(words);
                      std::memcpy(all.data(), bytes.get_binary().data(), 8 * words);
                      for (std::size_t i = all[0] + 1; i < words; i += 2)
                        if (all[i] == 2) put<std::uint64_t>(bytes, i, 7);
                    }),
            "");
}

}  // namespace
}  // namespace foamsim
