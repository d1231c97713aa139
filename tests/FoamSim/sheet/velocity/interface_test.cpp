#include <gtest/gtest.h>

#include <limits>
#include <string>
#include <vector>

#include "Base/error.h"
#include "FoamSim/sheet/velocity/biot_savart.h"
#include "FoamSim/sheet/velocity/direct.h"
#include "FoamSim/sheet/velocity/registry.h"

namespace foamsim {
namespace {

using lostopos::Vec3;

TEST(BiotSavartRegistry, MakesEveryNameItLists) {
  const auto names = velocity_sums().names();
  ASSERT_FALSE(names.empty());
  for (const std::string& name : names) EXPECT_NE(make_biot_savart(name), nullptr) << name;
}

TEST(BiotSavartRegistry, DirectIsTheDirectSum) {
  EXPECT_NE(dynamic_cast<DirectBiotSavart*>(make_biot_savart("direct").get()), nullptr);
}

TEST(BiotSavartRegistry, UnknownNameSaysWhichAreValid) {
  try {
    make_biot_savart("fasst");
    FAIL() << "no error";
  } catch (const base::InputError& error) {
    const std::string message = error.what();
    EXPECT_NE(message.find("'fasst'"), std::string::npos) << message;
    for (const std::string& name : velocity_sums().names()) EXPECT_NE(message.find(name), std::string::npos) << message;
  }
}

// Every registered summation must refuse the same arguments, and leave the output alone.
class EverySummation : public testing::Test {
 protected:
  void expect_refused(double delta) {
    for (const std::string& name : velocity_sums().names()) {
      EXPECT_THROW(make_biot_savart(name)->velocities(sources, targets, delta, out), base::InputError) << name;
      for (const Vec3& u : out) EXPECT_EQ(u, Vec3(7, 7, 7)) << name;
    }
  }

  VortexSources sources;
  std::vector<Vec3> targets = std::vector<Vec3>(3, Vec3(1, 2, 3));
  std::vector<Vec3> out = std::vector<Vec3>(3, Vec3(7, 7, 7));
};

TEST_F(EverySummation, RefusesBadDelta) {
  expect_refused(-1e-3);
  expect_refused(std::numeric_limits<double>::quiet_NaN());
  expect_refused(std::numeric_limits<double>::infinity());
}

TEST_F(EverySummation, RefusesWrongNumberOfVelocities) {
  out.resize(2);
  expect_refused(0.1);
}

TEST_F(EverySummation, RefusesSourcesOfUnequalLength) {
  sources.resize(4);
  sources.gz.resize(3);
  expect_refused(0.1);
}

TEST_F(EverySummation, NoSourcesGiveNoVelocity) {
  for (const std::string& name : velocity_sums().names()) {
    make_biot_savart(name)->velocities(sources, targets, 0, out);
    for (const Vec3& u : out) EXPECT_EQ(u, Vec3(0, 0, 0)) << name;
  }
}

TEST(VortexSourcesTest, ResizeKeepsMemoryAndValues) {
  VortexSources sources;
  sources.resize(100);
  sources.set(3, Vec3(1, 2, 3), Vec3(4, 5, 6));
  const double* memory = sources.gz.data();
  sources.resize(4);
  sources.resize(100);
  EXPECT_EQ(sources.gz.data(), memory);
  EXPECT_EQ(sources.size(), 100U);
  EXPECT_EQ(sources.x[3], 1);
  EXPECT_EQ(sources.gz[3], 6);
  EXPECT_EQ(sources.gz[4], 0);
}

}  // namespace
}  // namespace foamsim
