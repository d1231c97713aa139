// export-web and view as programs: one line for what cannot be used, and a server that ends as it is told.
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>

#include "program.h"

namespace foamsim::test {
namespace {

namespace fs = std::filesystem;

const bool has_viewer = FOAMSIM_HAS_VIEWER;

void expect_one_line(const ProgramResult& result, const std::string& part) {
  EXPECT_EQ(result.exit_code, 2) << result.error;
  EXPECT_EQ(std::ranges::count(result.error, '\n'), 1) << result.error;
  EXPECT_NE(result.error.find(part), std::string::npos) << result.error;
}

class WebCommands : public testing::Test {
 protected:
  WebCommands() {
    if (!has_viewer) return;
    EXPECT_EQ(run_foamsim("run sphere --set n=1 --steps 2 --set frame_every=1 --quiet --out " + run()).exit_code, 0);
  }
  void SetUp() override {
    if (!has_viewer) GTEST_SKIP() << "built without the viewer";
  }
  std::string run() const { return scratch_ / "run"; }
  std::string out() const { return scratch_ / "out.html"; }

 private:
  ScratchFolder scratch_;
};

TEST_F(WebCommands, ExportWritesOneFileThatNeedsNoOther) {
  const ProgramResult result = run_foamsim("export-web " + run() + " " + out());
  EXPECT_EQ(result.exit_code, 0) << result.error;
  EXPECT_NE(result.out.find("3 frames"), std::string::npos) << result.out;
  const std::string page = read_file(out());
  for (const char* outside : {"src=\"http", "href=\"http", "import(", "@import"})
    EXPECT_EQ(page.find(outside), std::string::npos) << outside;
  EXPECT_NE(page.find("data-name=\"frame/2\""), std::string::npos);
}

TEST_F(WebCommands, ExportReplacesAFileOnlyWithForce) {
  std::ofstream(out()) << "mine";
  expect_one_line(run_foamsim("export-web " + run() + " " + out()), "--force");
  EXPECT_EQ(read_file(out()), "mine");
  EXPECT_EQ(run_foamsim("export-web " + run() + " " + out() + " --force --quiet").exit_code, 0);
  EXPECT_GT(fs::file_size(out()), 100000u);
}

TEST_F(WebCommands, ExportSaysInOneLineWhatItCannotUse) {
  expect_one_line(run_foamsim("export-web " + run() + "/frames " + out()), "not the folder of a run");
  expect_one_line(run_foamsim("export-web " + run() + " " + out() + " --fields curl"), "unknown field 'curl'");
  expect_one_line(run_foamsim("export-web " + run() + " " + out() + " --every 0"), "--every");
  expect_one_line(run_foamsim("export-web " + run() + " " + out() + " --precision double"), "precision");
  expect_one_line(run_foamsim("export-web " + run() + " " + run() + "/no/out.html"), "out.html");
  fs::remove(run() + "/frames/frame_000001.ply");
  expect_one_line(run_foamsim("export-web " + run() + " " + out()), "lacks frames between steps 0 and 2");
  EXPECT_FALSE(fs::exists(out()));
}

// Started in the background, and ended when it has printed its address.
TEST_F(WebCommands, ViewServesUntilItIsTold) {
  const std::string script = std::string("'") + FOAMSIM_PROGRAM + " view " + run() + " > " + out() +
                             " & i=0; until [ -s " + out() +
                             " ] || [ $i -gt 600 ]; do sleep 0.1; i=$((i + 1)); done; kill -TERM $!; wait $!'";
  const ProgramResult result = ::test::run_program("sh -c", script);
  EXPECT_EQ(result.exit_code, 143) << result.error;
  EXPECT_TRUE(read_file(out()).starts_with("http://127.0.0.1:")) << read_file(out());
}

TEST_F(WebCommands, ViewSaysInOneLineWhatItCannotUse) {
  expect_one_line(run_foamsim("view " + run() + "/frames"), "not the folder of a run");
  expect_one_line(run_foamsim("view " + run() + " --port 70000"), "65535");
  expect_one_line(run_foamsim("view " + run() + " --fields curl"), "unknown field 'curl'");
}

TEST(WebCommandsWithoutTheViewer, SayWhatIsMissing) {
  if (has_viewer) GTEST_SKIP() << "built with the viewer";
  expect_one_line(run_foamsim("export-web out out.html"), "npm ci");
  expect_one_line(run_foamsim("view out"), "npm ci");
}

}  // namespace
}  // namespace foamsim::test
