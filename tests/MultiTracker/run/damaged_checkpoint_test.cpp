// Checkpoints that are not what the program wrote, whether by accident or on purpose.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "MultiTracker/run/tracking.h"
#include "tests/support/checkpoint_damage.h"

namespace multitracker {
namespace {

struct Sample {
  const char* name;
  const char* scene;
  std::vector<const char*> options;
};

void PrintTo(const Sample& sample, std::ostream* out) {  // NOLINT(readability-identifier-naming): GoogleTest's name
  *out << sample.name;
}

class DamagedCheckpointTest : public testing::TestWithParam<Sample> {
 protected:
  static ::test::DamagedCheckpoints damaged() {
    const SceneEntry& scene = scene_by_name(GetParam().scene);
    Origin origin{.scene = &scene, .options = options_of(scene)};
    for (const char* option : GetParam().options) origin.options.set_assignment(option, "test");
    // The flow of a surface from a file may depend on it.
    if (scene.at_walls == AtWalls::free) origin.given = scene.surface(origin.options).state();
    Tracking tracking(std::move(origin));
    for (int i = 0; i < 2; ++i) tracking.step();
    return {tracking, checkpoint_format(),
            [](const nlohmann::json& content) { return std::make_unique<Tracking>(checkpoint_from(content)); }};
  }
};

TEST_P(DamagedCheckpointTest, WithABitTurnedOverIsRefused) {
  damaged().expect_flips_refused(300, 15);
}

TEST_P(DamagedCheckpointTest, WithABitTurnedOverBehindTheChecksumIsRefusedOrGoesOn) {
  damaged().expect_hidden_flips_survived(200, 16);
}

TEST_P(DamagedCheckpointTest, WithStrangeValuesIsRefusedOrGoesOn) {
  damaged().expect_replacements_survived();
}

INSTANTIATE_TEST_SUITE_P(Kinds, DamagedCheckpointTest,
                         testing::Values(Sample{"sphere", "rotation", {"subdivisions=1"}},
                                         Sample{"walls", "T1", {"subdivisions=1"}},
                                         Sample{"normal_flow", "normal-flow", {"spheres=2"}}),
                         [](const auto& info) { return std::string(info.param.name); });

}  // namespace
}  // namespace multitracker
