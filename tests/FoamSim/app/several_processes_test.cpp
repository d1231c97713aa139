// Runs that several processes share, started by MPI's launcher on this machine.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "FoamSim/run/checkpoint.h"
#include "program.h"

namespace foamsim::test {
namespace {

namespace fs = std::filesystem;

// Processes may be more than cores, and the user may be root, as in a container.
std::string launcher(int processes) {
  return "OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1 OMPI_MCA_rmaps_base_oversubscribe=1 timeout "
         "300 " FOAMSIM_MPIEXEC " -n " +
         std::to_string(processes);
}

class SeveralProcesses : public testing::Test {
 protected:
  void SetUp() override {
    if (std::string(FOAMSIM_MPIEXEC).empty()) GTEST_SKIP() << "built without MPI";
  }
  ScratchFolder scratch_;

  std::string out(const std::string& folder) const { return " --out " + (scratch_ / folder); }
};

TEST_F(SeveralProcesses, HaveTheBitsOfOne) {
  for (const std::string options :
       {"--set velocity=direct", "--set velocity=tree", "--set velocity=direct --set dynamics=conservative",
        "--set velocity=tree --set dynamics=conservative"}) {
    const std::string run = "run doublebubble --set n=16 --steps 4 --force " + options;
    ASSERT_EQ(run_foamsim(run + out("one")).exit_code, 0) << options;
    for (int processes : {2, 3}) {
      const ProgramResult result = run_foamsim(run + out("shared"), launcher(processes));
      EXPECT_EQ(result.exit_code, 0) << result.error;
      for (const char* file : {"frames/frame_000004.ply", "checkpoint.cbor"})
        EXPECT_TRUE(read_file(scratch_.path() / "one" / file) == read_file(scratch_.path() / "shared" / file))
            << options << ", " << processes << " processes: " << file;
    }
  }
}

TEST_F(SeveralProcesses, SpeakWithOneVoice) {
  const ProgramResult good = run_foamsim("run doublebubble --steps 2" + out("run"), launcher(3));
  EXPECT_EQ(good.exit_code, 0);
  EXPECT_EQ(good.out.find("finished after step 2"), good.out.rfind("finished after step 2")) << good.out;
  for (const auto& [arguments, text] :
       {std::pair("run nosuch", "unknown scene 'nosuch'"), std::pair("study modes", "the command 'run' alone")}) {
    const ProgramResult bad = run_foamsim(arguments + out("bad"), launcher(2));
    EXPECT_EQ(bad.exit_code, 2) << bad.error;
    EXPECT_NE(bad.error.find(text), std::string::npos) << bad.error;
    EXPECT_EQ(bad.error.find(text), bad.error.rfind(text)) << bad.error;
    EXPECT_FALSE(fs::exists(scratch_ / "bad"));
  }
}

// The launcher ends the others; what was last saved is whole, and where a run goes on from.
TEST_F(SeveralProcesses, EndTogetherAndLoseNothing) {
  const std::string run = "run doublebubble --set n=16 --set checkpoint_every=2";
  // One of the processes is ended as soon as a checkpoint is there.
  const std::string folder = scratch_ / "run";
  const std::string end_one = "sh -c 'for i in $(seq 600); do [ -f " + folder +
                              "/checkpoint.cbor ] && break; sleep 0.05; done; pkill -KILL -n -f " + folder + "' & ";
  const ProgramResult result = run_foamsim(run + " --steps 100000" + out("run"), end_one + launcher(2));
  EXPECT_NE(result.exit_code, 0);
  EXPECT_NO_THROW(lostopos::run::read_checkpoint(folder + "/checkpoint.cbor", checkpoint_format(),
                                                 [](const nlohmann::json& content) { EXPECT_FALSE(content.empty()); }));
  const ProgramResult resumed = run_foamsim("run --resume " + folder + "/checkpoint.cbor --steps 100000" + out("on"),
                                            "timeout --foreground --preserve-status -s INT 1");
  EXPECT_EQ(resumed.exit_code, 130) << resumed.error;
}

}  // namespace
}  // namespace foamsim::test
