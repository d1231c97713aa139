// The n-th write, fsync, rename, opening of a file or allocation of a run fails: the run ends with its exit code and
// one line, or does without, and its folder goes on to the bits of a run that nothing happened to.
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/FoamSim/app/same_run.h"

namespace foamsim::test {
namespace {

namespace fs = std::filesystem;
using ::test::ProgramResult;
using ::test::ScratchFolder;

constexpr const char* run_of_a_scene =
    "run doublebubble --set n=8 --set checkpoint_every=2 --set frame_every=2 --steps 6 --threads 1 --quiet";

ProgramResult run_foamsim(const std::string& arguments, const std::string& before = "") {
  return ::test::run_program(FOAMSIM_PROGRAM, arguments, before);
}

struct Kind {
  const char* name;
  int exit_code;  // docs/output.md "Exit codes"
};

void PrintTo(const Kind& kind, std::ostream* out) {  // NOLINT(readability-identifier-naming): GoogleTest's name
  *out << kind.name;
}

ProgramResult run_with_fault(const Kind& kind, long at, const std::string& folder, const std::string& count_file) {
  return run_foamsim(std::string(run_of_a_scene) + " --out " + folder,
                     std::string("LD_PRELOAD=" FAIL_NTH " FAULT_KIND=") + kind.name +
                         " FAULT_AT=" + std::to_string(at) + " FAULT_COUNT=" + count_file);
}

// FAULT_TRIALS of them spread over all; where that is as many as in the long suite, all of the first ones, too.
std::vector<long> chosen(long count) {
  constexpr long trials = FAULT_TRIALS, every_one_of = FAULT_EVERY_ONE_OF;
  std::vector<long> places;
  for (long n = 1; n <= std::min(count, every_one_of); ++n) places.push_back(n);
  const long spread = std::min(trials, count);
  for (long i = 0; i < spread; ++i) places.push_back(1 + i * count / spread);
  std::ranges::sort(places);
  places.erase(std::unique(places.begin(), places.end()), places.end());
  return places;
}

class ProgramFault : public testing::TestWithParam<Kind> {
 protected:
  // What a user does next, the fault being mended.
  static void go_on(const std::string& folder) {
    const bool saved = fs::exists(folder + "/checkpoint.cbor");
    const ProgramResult result = run_foamsim(saved ? "run --resume " + folder + " --steps 6 --threads 1 --quiet"
                                                   : std::string(run_of_a_scene) + " --force --out " + folder);
    ASSERT_EQ(result.exit_code, 0) << result.error;
  }

  void try_at(long n, const std::string& whole, const ScratchFolder& scratch) {
    SCOPED_TRACE(std::string(GetParam().name) + " " + std::to_string(n));
    const std::string folder = scratch / "run";
    const ProgramResult result = run_with_fault(GetParam(), n, folder, scratch / "unused");
    if (result.exit_code != 0) {  // some can be done without: the name in a lock
      EXPECT_EQ(result.exit_code, GetParam().exit_code) << result.error;
      EXPECT_EQ(std::ranges::count(result.error, '\n'), 1) << result.error;
      EXPECT_TRUE(result.error.starts_with("foamsim: ")) << result.error;
      go_on(folder);
    }
    expect_same_files(whole, folder);
    fs::remove_all(folder);
  }
};

TEST_P(ProgramFault, EndsInWordsAndGoesOnToTheSameBits) {
  const ScratchFolder scratch;
  const std::string whole = scratch / "whole", count_file = scratch / "count";
  ASSERT_EQ(run_with_fault(GetParam(), 0, whole, count_file).exit_code, 0);
  const long count = std::stol(::test::read_file(count_file));
  ASSERT_GT(count, 5) << "the library that makes calls fail does not see them";
  for (const long n : chosen(count)) {
    try_at(n, whole, scratch);
    if (HasFatalFailure()) return;
  }
}

INSTANTIATE_TEST_SUITE_P(Each, ProgramFault,
                         testing::Values(Kind{"write", 4}, Kind{"sync", 4}, Kind{"rename", 4}, Kind{"open", 4},
                                         Kind{"memory", 3}),
                         [](const auto& info) { return info.param.name; });

}  // namespace
}  // namespace foamsim::test
