// Submission to a queue that is made of scripts: what sbatch is called with, when, and how often.
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>

#include "program.h"

namespace foamsim::test {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

// sbatch, squeue and sinfo in a folder of their own, in front of PATH. Each notes how it was called.
class ScriptedSlurm {
 public:
  ScriptedSlurm() {
    fs::create_directories(scratch_.path() / "bin");
    std::ofstream(scratch_ / "grid.toml")
        << "scene = \"doublebubble\"\nsteps = 1\n[options]\nframe_every = 0\n[sweep]\nn = [8, 9, 10]\n";
    set("sbatch", "cp " + record() + " " + at_submission() + "; echo 'sbatch: a warning' >&2; echo 4242");
    set("squeue", "true");
    set("sinfo", "printf 'main\\nlong\\n'");
  }
  void set(const std::string& program, const std::string& script) const {
    const std::string file = scratch_ / ("bin/" + program);
    std::ofstream(file) << "#!/bin/sh\n[ \"$1\" = --version ] && exit 0\necho \"$*\" >>" << (scratch_ / program)
                        << ".calls\n"
                        << script << "\n";
    fs::permissions(file, fs::perms::owner_all);
  }
  ProgramResult submit(const std::string& more = "") const {
    return run_foamsim("sweep " + grid() + " --slurm --out " + out() + " " + more, path());
  }
  ProgramResult sweep(const std::string& arguments) const {
    return run_foamsim("sweep " + arguments + " --out " + out(), path());
  }
  std::string path() const {
    return "env TMPDIR=" + scratch_.path().string() + " PATH=" + (scratch_ / "bin") + ":$PATH";
  }
  std::string grid() const { return scratch_ / "grid.toml"; }
  std::string out() const { return scratch_ / "out"; }
  std::string record() const { return scratch_ / "out/sweep.json"; }
  std::string at_submission() const { return scratch_ / "record"; }
  std::string calls(const std::string& program) const { return read_file(scratch_ / (program + ".calls")); }
  long submissions() const {
    const std::string text = calls("sbatch");
    return std::ranges::count(text, '\n');
  }
  json recorded() const { return json::parse(read_file(record()))["submissions"]; }

 private:
  ScratchFolder scratch_;
};

TEST(SweepOnSlurm, RecordsThatItWillBeforeItSubmitsOneArrayJob) {
  const ScriptedSlurm slurm;
  const ProgramResult result = slurm.submit("--workers 2 --threads 3 --partition long --sbatch=--mem=2G");
  ASSERT_EQ(result.exit_code, 0) << result.error;
  EXPECT_NE(result.out.find("submitted 3 runs as job 4242"), std::string::npos) << result.out;
  EXPECT_EQ(slurm.submissions(), 1);
  for (const char* word : {"--array=0-2%2", "--cpus-per-task=3", "--partition=long", "--mem=2G"})
    EXPECT_NE(slurm.calls("sbatch").find(word), std::string::npos) << slurm.calls("sbatch");
  const json before = json::parse(read_file(slurm.at_submission()))["submissions"];
  ASSERT_EQ(before.size(), 1U);
  EXPECT_EQ(before[0]["job"], "");
  EXPECT_NE(slurm.calls("sbatch").find("--job-name=" + before[0]["job_name"].get<std::string>() + " "),
            std::string::npos);
  EXPECT_EQ(slurm.recorded()[0]["job"], "4242");
  EXPECT_EQ(slurm.recorded()[0]["job_name"], before[0]["job_name"]);
}

TEST(SweepOnSlurm, ATaskMakesItsRunAndWhatIsQueuedIsNotSubmittedAgain) {
  const ScriptedSlurm slurm;
  ASSERT_EQ(slurm.submit().exit_code, 0);
  EXPECT_EQ(::test::run_program("sh", slurm.out() + "/job.sh", "SLURM_ARRAY_TASK_ID=1").exit_code, 0);
  slurm.set("squeue", "echo '4242 0'; echo '4242 2'");
  EXPECT_EQ(slurm.sweep("--collect").exit_code, 5);
  const std::string table = read_file(slurm.out() + "/table.csv");
  for (const char* row : {"\nn=8,8,queued,", "\nn=9,9,finished,0,", "\nn=10,10,queued,"})
    EXPECT_NE(table.find(row), std::string::npos) << table;
  EXPECT_EQ(slurm.submit().exit_code, 5);
  EXPECT_EQ(slurm.submissions(), 1);
  // Here it would be made a second time.
  EXPECT_EQ(slurm.sweep("").exit_code, 2);
  // A task that was lost is submitted again, and it alone.
  slurm.set("squeue", "echo '4242 0'");
  EXPECT_EQ(slurm.submit().exit_code, 0);
  EXPECT_NE(slurm.calls("sbatch").find("--array=2 "), std::string::npos) << slurm.calls("sbatch");
}

TEST(SweepOnSlurm, ThatEndsBeforeItRecordsTheNumberFindsTheJobByItsName) {
  const ScriptedSlurm slurm;
  slurm.set("sbatch", "kill -KILL $PPID; echo 77");
  slurm.submit();
  ASSERT_EQ(slurm.submissions(), 1);
  const std::string job_name = slurm.recorded()[0]["job_name"];
  EXPECT_EQ(slurm.recorded()[0]["job"], "");
  // The queue does not answer: nobody knows.
  slurm.set("squeue", "echo 'cannot reach the controller' >&2; exit 1");
  const ProgramResult unknown = slurm.submit();
  EXPECT_EQ(unknown.exit_code, 3);
  EXPECT_NE(unknown.error.find("cannot reach the controller"), std::string::npos) << unknown.error;
  EXPECT_EQ(slurm.submissions(), 1);
  // It has the job.
  slurm.set("squeue", "case \"$*\" in *--name=" + job_name + "*|*--jobs=77*) printf '77 0\\n77 1\\n77 2\\n' ;; esac");
  EXPECT_EQ(slurm.submit().exit_code, 5);
  EXPECT_EQ(slurm.submissions(), 1);
  EXPECT_EQ(slurm.recorded()[0]["job"], "77");
}

TEST(SweepOnSlurm, ThatEndsBeforeTheQueueHadTheJobSubmitsItWhenCalledAgain) {
  const ScriptedSlurm slurm;
  slurm.set("sbatch", "kill -KILL $PPID; exit 1");
  slurm.submit();
  slurm.set("sbatch", "echo 78");
  EXPECT_EQ(slurm.submit().exit_code, 0);
  ASSERT_EQ(slurm.recorded().size(), 1U);
  EXPECT_EQ(slurm.recorded()[0]["job"], "78");
}

TEST(SweepOnSlurm, ARefusedJobIsOneLineAndNotRecorded) {
  const ScriptedSlurm slurm;
  slurm.set("sbatch", "echo 'sbatch: error: Invalid account' >&2; exit 1");
  const ProgramResult result = slurm.submit();
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_EQ(std::ranges::count(result.error, '\n'), 1) << result.error;
  EXPECT_NE(result.error.find("Invalid account"), std::string::npos) << result.error;
  EXPECT_TRUE(slurm.recorded().empty());
}

TEST(SweepOnSlurm, WithoutSlurmOrThePartitionNothingIsLeftBehind) {
  const ScriptedSlurm slurm;
  const ProgramResult partition = slurm.submit("--partition lnog");
  EXPECT_EQ(partition.exit_code, 2);
  EXPECT_NE(partition.error.find("there is no partition 'lnog' (there are: main, long)"), std::string::npos)
      << partition.error;
  const ProgramResult without =
      ::test::run_program(FOAMSIM_PROGRAM, "sweep " + slurm.grid() + " --slurm --out " + slurm.out(), "PATH=/nowhere");
  EXPECT_EQ(without.exit_code, 2);
  EXPECT_NE(without.error.find("cannot run sbatch"), std::string::npos) << without.error;
  EXPECT_EQ(std::ranges::count(without.error, '\n'), 1) << without.error;
  EXPECT_FALSE(fs::exists(slurm.out()));
}

}  // namespace
}  // namespace foamsim::test
