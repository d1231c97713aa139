// --simd: the same bits of a run on every instruction set that this machine has.
#include <gtest/gtest.h>

#include <algorithm>

#include "FoamSim/sheet/velocity/direct_kernel.h"
#include "tests/FoamSim/app/same_run.h"

namespace foamsim::test {
namespace {

::test::ProgramResult run_foamsim(const std::string& arguments) {
  return ::test::run_program(FOAMSIM_PROGRAM, arguments);
}

TEST(Simd, OfEveryKindGivesTheSameBits) {
  const ::test::ScratchFolder scratch;
  const std::string run = "run doublebubble --set n=8 --set frame_every=1 --steps 4 --quiet --out ";
  ASSERT_EQ(run_foamsim(run + (scratch / "best")).exit_code, 0);
  for (const std::string& target : simd_targets()) {
    SCOPED_TRACE(target);
    const auto result = run_foamsim(std::string(run).append(scratch / target).append(" --simd ").append(target));
    ASSERT_EQ(result.exit_code, 0) << result.error;
    expect_same_files(scratch / "best", scratch / target);
  }
}

TEST(Simd, ThatTheMachineLacksIsRefusedWithThoseThatItHas) {
  const ::test::ScratchFolder scratch;
  const auto result = run_foamsim("run doublebubble --simd AVX9 --out " + (scratch / "run"));
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_EQ(std::ranges::count(result.error, '\n'), 1) << result.error;
  EXPECT_NE(result.error.find("'AVX9'"), std::string::npos) << result.error;
  for (const std::string& target : simd_targets()) EXPECT_NE(result.error.find(target), std::string::npos);
  EXPECT_FALSE(std::filesystem::exists(scratch.path() / "run"));
}

}  // namespace
}  // namespace foamsim::test
