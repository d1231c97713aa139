// Every case of the stability study: it builds, and its criterion can fail.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <set>

#include "FoamSim/studies/stability/stability_csv.h"
#include "FoamSim/studies/stability/stability_study.h"
#include "LosTopos/error.h"
#include "LosTopos/mesh/audit.h"
#include "trajectories.h"

namespace foamsim {
namespace {

using lostopos::Vec3;
using test::quiet_trajectory;

class StabilityCases : public testing::TestWithParam<std::string> {
 protected:
  const StabilityCase& what() const { return stability_case_by_name(GetParam()); }
  std::size_t runs() const { return what().runs({}).size(); }

  // One motion for each of the case's runs that its criterion passes: quiet ones, changed to what the case asks for.
  std::vector<Trajectory> good() const {
    std::vector<Trajectory> all(runs(), quiet_trajectory());
    if (GetParam() == "meeting") all[0].samples.back().topology_totals.snaps = 3;
    if (GetParam() == "t1-threshold")
      for (std::size_t i = 1; i < all[0].samples.size(); ++i) all[0].samples[i].topology_totals.separations = 7;
    if (GetParam() == "shrinking") {
      for (Metrics& m : all[0].samples)
        m.volumes = {{lostopos::air, -4.1}, {lostopos::Region(1), 0.1}, {lostopos::Region(2), 4.0}};
      all[0].samples.back().volumes = {{lostopos::air, -4.0}, {lostopos::Region(2), 4.0}};
    }
    if (GetParam() == "scaled") {
      all[1] = scaled(all[1], 0x1p20);
      all[2] = scaled(all[2], 0x1p-20);
    }
    if (GetParam() == "moved")
      for (Vec3& x : all[1].end_positions) x += offset();
    if (GetParam() == "moved")
      for (Metrics& m : all[1].samples) m.centroid += offset();
    return all;
  }

  bool passes(const std::vector<Trajectory>& t) const { return what().judge(t).passed; }

 private:
  static Vec3 offset() { return 1000 * Vec3(2, -6, 3) / 7; }
  static Trajectory scaled(Trajectory t, double s) {
    for (Metrics& m : t.samples) {
      m.area *= s * s;
      m.energy *= s * s * s * s * s;
      m.impulse_scale *= s * s * s * s;
      for (auto& volume : m.volumes) volume.volume *= s * s * s;
    }
    for (Vec3& x : t.end_positions) x *= s;
    return t;
  }
};

TEST_P(StabilityCases, BuildSoundSurfacesAndMakeASoundStep) {
  for (const CaseRun& run : what().runs({})) {
    EXPECT_GE(run.steps, 10) << run.label;
    const auto motion = run.start();
    const auto report = lostopos::audit(motion->mesh());
    ASSERT_TRUE(report.clean()) << run.label << ": " << report.text();
    const Metrics start = motion->metrics();
    motion->step();
    const Metrics next = motion->metrics();
    EXPECT_EQ(start.step, 0);
    EXPECT_EQ(next.step, 1);
    EXPECT_GT(start.area, 0);
    EXPECT_TRUE(std::isfinite(next.energy));
    EXPECT_LT(next.volume_drift_max, 0.1);
    // So that what is judged is not a surface at rest in the literal sense.
    EXPECT_NE(next.centroid, start.centroid);
  }
}

TEST_P(StabilityCases, PassWhatTheyShouldAndFailEveryBrokenMotion) {
  const auto fine = good();
  ASSERT_TRUE(passes(fine)) << what().judge(fine).reason;
  const auto edits = std::vector<std::function<void(Trajectory&)>>{
      [](Trajectory& t) { t.error = "step 2: the surface cannot be moved"; },
      [](Trajectory& t) { t.defect = "after step 1: an edge meets a triangle"; },
      [](Trajectory& t) { t.out_of_time = true; },
      [](Trajectory& t) { t.samples.pop_back(); },
      [](Trajectory& t) { t.samples[1].area = std::numeric_limits<double>::quiet_NaN(); },
  };
  for (std::size_t i = 0; i < edits.size(); ++i) {
    auto broken = good();
    edits[i](broken[0]);
    EXPECT_FALSE(passes(broken)) << "edit " << i;
    EXPECT_FALSE(what().judge(broken).reason.empty());
  }
}

TEST_P(StabilityCases, FailWhatTheyAreThereToFind) {
  const std::string name = GetParam();
  auto broken = good();
  if (name == "scaled" || name == "moved") {
    broken[1].end_positions[0].x() += 1e-5 * std::sqrt(broken[1].samples[0].area);
  } else if (name == "meeting") {
    broken[0].samples.back().topology_totals.snaps = 0;
  } else if (name == "t1-threshold") {
    broken[0].samples.back().topology_totals.separations = 9;  // two of them late
  } else if (name == "shrinking") {
    broken[0].samples.back().volumes = {{lostopos::air, -4.0}, {lostopos::Region(1), 1e-9}, {lostopos::Region(2), 4.0}};
    auto jumping = good();
    jumping[0].samples.back().volumes = {{lostopos::air, -3.9}, {lostopos::Region(2), 3.9}};
    EXPECT_FALSE(passes(jumping));
  } else {
    broken[0].samples.back().energy *= 1.5;
    auto drifting = good();
    drifting[0].samples.back().volume_drift_max = 0.5;
    EXPECT_FALSE(passes(drifting));
    auto flying = good();
    flying[0].samples.back().impulse = Vec3(1, 0, 0);
    EXPECT_EQ(passes(flying), name == "time-steps") << "a step's stability is not judged by the impulse";
  }
  EXPECT_FALSE(passes(broken));
}

std::vector<std::string> case_names() {
  std::vector<std::string> names;
  for (const StabilityCase& c : stability_cases()) names.emplace_back(c.name);
  return names;
}

INSTANTIATE_TEST_SUITE_P(All, StabilityCases, testing::ValuesIn(case_names()), [](const auto& info) {
  std::string name = info.param;
  std::ranges::replace(name, '-', '_');
  return name;
});

TEST(TimeSteps, FindTheLargestThatIsStable) {
  const StabilityCase& c = stability_case_by_name("time-steps");
  std::vector<Trajectory> t(c.runs({}).size(), quiet_trajectory());
  ASSERT_EQ(t.size(), 6U);
  EXPECT_EQ(c.judge(t).figure, 0.08);
  t[4].samples.back().energy *= 2;
  EXPECT_EQ(c.judge(t).figure, 0.02);
  EXPECT_TRUE(c.judge(t).passed) << "larger steps than the usual one may fail";
  t[2].error = "step 7: no";
  EXPECT_EQ(c.judge(t).figure, 0.005);
  EXPECT_FALSE(c.judge(t).passed);
  t[0].error = "step 1: no";
  EXPECT_FALSE(c.judge(t).figure.has_value());
}

// A motion that fails on its third step, with energies 1 and 1.5 before.
class FailingMotion final : public MeasuredMotion {
 public:
  FailingMotion() { (void)mesh_.add_triangle(vertex(0), vertex(1), vertex(2), {lostopos::Region(1), lostopos::air}); }
  void step() override {
    if (steps_ == 2) throw lostopos::MotionError("stuck");
    ++steps_;
    metrics_.energy = 0.5 * static_cast<double>(steps_ + 1);
  }
  long steps() const override { return steps_; }
  double time() const override { return 0; }
  const lostopos::SurfaceMesh& mesh() const override { return mesh_; }
  const lostopos::run::StepWork& last() const override { return work_; }
  const Metrics& metrics() const override { return metrics_; }

 private:
  lostopos::Vertex vertex(double x) { return mesh_.add_vertex({x, x * x, 0}); }
  lostopos::SurfaceMesh mesh_;
  long steps_ = 0;
  lostopos::run::StepWork work_;
  Metrics metrics_;
};

TEST(Record, KeepsWhatWasDoneBeforeAFailure) {
  const Trajectory t = record([] { return std::make_unique<FailingMotion>(); }, {.steps = 10, .closed_surface = false});
  EXPECT_EQ(t.steps(), 2);
  EXPECT_FALSE(t.complete());
  EXPECT_EQ(t.error, "step 3: stuck");
  EXPECT_EQ(t.defect, "");
}

TEST(Record, NotesDefectsAndSurfacesThatCannotBeBuilt) {
  const Trajectory open = record([] { return std::make_unique<FailingMotion>(); }, {.steps = 2});
  EXPECT_NE(open.defect, "") << "one triangle bounds no bubble";
  const Trajectory none =
      record([]() -> std::unique_ptr<MeasuredMotion> { throw base::InputError("no such shape"); }, {});
  EXPECT_EQ(none.error, "step 1: no such shape");
  EXPECT_TRUE(none.samples.empty());
  for (const StabilityCase& c : stability_cases())
    EXPECT_FALSE(c.judge(std::vector<Trajectory>(c.runs({}).size(), none)).passed) << c.name;
}

TEST(Record, StopsWhatHasBlownUp) {
  const Trajectory t = record([] { return std::make_unique<FailingMotion>(); },
                              {.steps = 10, .most_energy = 1.2, .closed_surface = false});
  EXPECT_TRUE(t.blown_up);
  EXPECT_EQ(t.steps(), 2);
  EXPECT_EQ(t.error, "");
}

TEST(Record, StopsWhenAskedOrOutOfTime) {
  auto start = [] { return std::make_unique<FailingMotion>(); };
  const Trajectory slow = record(start, {.steps = 10, .most_seconds = 0, .closed_surface = false});
  EXPECT_TRUE(slow.out_of_time);
  EXPECT_LT(slow.steps(), 2);
  const Trajectory stopped =
      record(start, {.steps = 10, .closed_surface = false}, {.progress = {}, .interrupted = [] { return true; }});
  EXPECT_TRUE(stopped.interrupted);
  EXPECT_EQ(stopped.steps(), 0);
}

TEST(StabilityStudy, ChecksItsOptions) {
  using Options = StabilityOptions;
  EXPECT_NO_THROW(validate(Options{}));
  for (const Options& bad :
       {Options{.cases = {"lon"}}, Options{.areas = {"avraged"}}, Options{.areas = {}}, Options{.remeshing = {}},
        Options{.steps_scale = 0}, Options{.steps_scale = 11}, Options{.assignments = {"inertai=false"}},
        Options{.assignments = {"inertia=false"}}, Options{.most_seconds = 0}})
    EXPECT_THROW(validate(bad), base::InputError);
}

// A part that is switched off is off in the motion, and the conservative scheme is held to its own limits.
TEST(StabilityStudy, SimulatesWithTheOptionsThatAreGiven) {
  StabilityOptions options{
      .cases = {"quad-point"}, .areas = {"conservative"}, .remeshing = {false}, .steps_scale = 0.05};
  const auto whole = study_stability(options);
  options.assignments = {"effects=surface_tension", "viscosity=0"};
  const auto apart = study_stability(options);
  ASSERT_EQ(whole.size() + apart.size(), 2U);
  EXPECT_LT(whole.front().physics.volume_drift, 1e-12);
  EXPECT_GT(apart.front().physics.volume_drift, 1e-7);
}

TEST(StabilityCriteria, HoldTheConservativeSchemeToLess) {
  Trajectory trajectory;
  for (const double energy : {1.0, 1.0, 1.005}) {
    Metrics sample;
    sample.energy = energy;
    trajectory.samples.push_back(sample);
  }
  trajectory.steps_asked = 2;
  trajectory.limits = physics_limits("averaged");
  EXPECT_TRUE(Judgement().require_physics(trajectory).verdict().passed);
  trajectory.limits = physics_limits("conservative");
  EXPECT_FALSE(Judgement().require_physics(trajectory).verdict().passed);
}

TEST(StabilityStudy, HasARowForEveryCombination) {
  StabilityOptions options{.cases = {"quad-point", "scaled"}, .areas = {"naive", "averaged"}, .steps_scale = 0.01};
  std::set<std::string> seen;
  double last = 0;
  const auto rows = study_stability(
      options,
      {.row = [&](const StabilityRow& row) { seen.insert(row.name + row.area + (row.remeshing ? "on" : "off")); },
       .progress =
           [&](const std::string&, double fraction) {
             EXPECT_GE(fraction, last);
             last = fraction;
           },
       .interrupted = {}});
  EXPECT_EQ(rows.size(), 8U);
  EXPECT_EQ(seen.size(), 8U);
  EXPECT_NEAR(last, 1, 1e-9);
  for (const StabilityRow& row : rows) EXPECT_EQ(row.steps, row.steps_asked);
  EXPECT_TRUE(study_stability(options, {.row = {}, .progress = {}, .interrupted = [] { return true; }}).empty());
}

TEST(StabilityCsv, HasAsManyCellsAsTheHeader) {
  StabilityRow row;
  row.name = "long";
  row.verdict = {.passed = false, .reason = "energy rises, twice\nover", .figure_name = "", .figure = {}};
  const std::string header = stability_csv_header(), line = stability_csv_row(row);
  EXPECT_EQ(std::ranges::count(header, ','), std::ranges::count(line, ','));
  EXPECT_TRUE(line.ends_with(",energy rises; twice over\n")) << line;
}

}  // namespace
}  // namespace foamsim
