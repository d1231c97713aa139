// What goes into an exported file comes out of it, and what cannot be exported leaves nothing.
#include "FoamSim/web/export_web.h"

#include <gtest/gtest.h>

#include "Base/error.h"
#include "Base/interruption.h"
#include "small_run.h"
#include "tests/support/run_program.h"
#include "unpacked_frame.h"

namespace foamsim::web {
namespace {

namespace fs = std::filesystem;
using test::element;
using test::SmallRun;
using test::UnpackedFrame;

std::string page_of(const SmallRun& run, const ExportOptions& options = {}) {
  const ::test::ScratchFolder scratch;
  export_web(run.path(), scratch / "out.html", test::stub_page, options, {});
  return ::test::read_file(scratch / "out.html");
}

ExportOptions with(std::vector<std::string> fields, Precision precision = Precision::quantised) {
  return {.frames = {.fields = std::move(fields), .precision = precision}};
}

TEST(ExportWeb, PutsARunIntoThePage) {
  const std::string page = page_of(SmallRun());
  EXPECT_TRUE(page.starts_with("<title>two</title>\n"));
  EXPECT_TRUE(page.ends_with("<p>end</p>\n"));
  EXPECT_EQ(test::element_names(page), (std::vector<std::string>{"frame/0", "frame/2", "frame/4", "frame/6", "run"}));
  const nlohmann::json run = nlohmann::json::parse(element(page, "run"));
  EXPECT_EQ(run["scene"], "two");
  EXPECT_EQ(run["command"], "foamsim run <two>");
  EXPECT_EQ(run["frames"][3]["step"], 6);
  EXPECT_EQ(run["frames"][3]["time"], 3.0);
  EXPECT_EQ(run["metrics"]["area"], (std::vector<double>{1.5, 1.75, 2, 2.25}));
  EXPECT_FALSE(run["metrics"].contains("empty"));
  EXPECT_EQ(run["volumes"]["volumes"]["2"], (std::vector<double>{1, 1.5}));
  EXPECT_EQ(run["events"][0]["kind"], "snap");
  EXPECT_EQ(run["bubbles"]["6"].size(), 2u);
}

TEST(ExportWeb, KeepsSurfacesInSinglePrecisionToTheBit) {
  const std::string page = page_of(SmallRun(), with({}, Precision::single));
  for (long step = 0; step <= 6; step += 2) {
    const UnpackedFrame frame(element(page, "frame/" + std::to_string(step)));
    const lostopos::SurfaceData surface = SmallRun::surface(step);
    const std::vector<float> positions = frame.array<float>("positions");
    ASSERT_EQ(positions.size(), 15u);
    for (std::size_t i = 0; i < positions.size(); ++i)
      EXPECT_EQ(positions[i], static_cast<float>(surface.positions[i / 3][static_cast<Eigen::Index>(i % 3)]));
    const auto corners = frame.array<std::uint32_t>("triangles"), pair = frame.array<std::uint32_t>("pair");
    ASSERT_EQ(pair.size(), surface.triangles.size());
    for (std::size_t t = 0; t < pair.size(); ++t) {
      for (std::size_t k = 0; k < 3; ++k) EXPECT_EQ(corners[3 * t + k], surface.triangles[t][k]);
      EXPECT_EQ(frame.head["pairs"][pair[t]][0], surface.labels[t].p.index());
      EXPECT_EQ(frame.head["pairs"][pair[t]][1], surface.labels[t].q.index());
    }
    EXPECT_EQ(frame.array<std::uint32_t>("borders"), (std::vector<std::uint32_t>{0, 1, 0, 2, 1, 2}));
    EXPECT_EQ(frame.size_by_head(), element(page, "frame/" + std::to_string(step)).size());
  }
}

TEST(ExportWeb, QuantisesPositionsToAStepOfTheirBox) {
  const std::string page = page_of(SmallRun());
  const UnpackedFrame frame(element(page, "frame/4"));
  const lostopos::SurfaceData surface = SmallRun::surface(4);
  const std::vector<std::uint16_t> steps = frame.array<std::uint16_t>("positions");
  ASSERT_EQ(steps.size(), 15u);
  for (std::size_t i = 0; i < steps.size(); ++i) {
    const double low = frame.head["box"][0][i % 3], high = frame.head["box"][1][i % 3];
    EXPECT_NEAR(low + steps[i] / 65534.0 * (high - low), surface.positions[i / 3][static_cast<Eigen::Index>(i % 3)],
                (high - low) / 65534);
  }
}

TEST(ExportWeb, TakesTheFieldsOfTheRun) {
  const SmallRun run(true);
  const UnpackedFrame frame(element(page_of(run, with({}, Precision::single)), "frame/0"));
  std::vector<std::string> names;
  for (const nlohmann::json& field : frame.head["fields"]) names.push_back(field["name"]);
  EXPECT_EQ(names, (std::vector<std::string>{"mean_curvature", "pressure_jump", "flow", "height"}));
  EXPECT_EQ(frame.array<float>("field/height"), (std::vector<float>{0, 1, 2, 3, 4}));
  EXPECT_EQ(frame.array<float>("field/flow"), (std::vector<float>{5, 0, 1, 10, 0, 0, 0}));
  const UnpackedFrame chosen(element(page_of(run, with({"height"})), "frame/0"));
  EXPECT_EQ(chosen.head["fields"].size(), 1u);
  EXPECT_EQ(chosen.array<std::uint16_t>("field/height").back(), 65534);
  EXPECT_TRUE(UnpackedFrame(element(page_of(run, with({"none"})), "frame/0")).head["fields"].empty());
}

TEST(ExportWeb, TakesEveryNthFrameAndTheLast) {
  const std::string page = page_of(SmallRun(), {.every = 2});
  EXPECT_EQ(test::element_names(page), (std::vector<std::string>{"frame/0", "frame/4", "frame/6", "run"}));
}

TEST(ExportWeb, SaysTheSizeBeforeItWrites) {
  const SmallRun run;
  const ::test::ScratchFolder scratch;
  std::uintmax_t expected = 0;
  ExportHooks hooks;
  hooks.begin = [&](std::uintmax_t bytes, std::size_t frames) {
    expected = bytes;
    EXPECT_EQ(frames, 4u);
    EXPECT_FALSE(fs::exists(scratch / "out.html"));
  };
  const ExportOutcome outcome = export_web(run.path(), scratch / "out.html", test::stub_page, {}, hooks);
  EXPECT_EQ(outcome.bytes, fs::file_size(scratch / "out.html"));
  EXPECT_GT(expected, outcome.bytes / 2);
  EXPECT_LT(expected, outcome.bytes * 2);
}

TEST(ExportWeb, IsTheSameFileEachTime) {
  const SmallRun run(true);
  EXPECT_EQ(page_of(run), page_of(run));
}

TEST(ExportWeb, ThatIsInterruptedLeavesNothing) {
  const SmallRun run;
  const ::test::ScratchFolder scratch;
  int asked = 0;
  ExportHooks hooks;
  hooks.interrupted = [&] { return ++asked > 2; };
  EXPECT_THROW(export_web(run.path(), scratch / "out.html", test::stub_page, {}, hooks), base::Interrupted);
  EXPECT_TRUE(fs::is_empty(scratch.path()));
}

TEST(ExportWeb, ThatMeetsADamagedFrameLeavesNothing) {
  const SmallRun run;
  run.write("frames/frame_000004.ply", "ply\nno\n");
  const ::test::ScratchFolder scratch;
  EXPECT_THROW(export_web(run.path(), scratch / "out.html", test::stub_page, {}, {}), base::InputError);
  EXPECT_TRUE(fs::is_empty(scratch.path()));
}

}  // namespace
}  // namespace foamsim::web
