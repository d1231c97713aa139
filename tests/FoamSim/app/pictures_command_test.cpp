// foamsim render and movie: what each option does to a picture, and what is said where there is no film.
#include <gtest/gtest.h>

#include <fstream>

#include "program.h"

namespace foamsim::test {
namespace {

namespace fs = std::filesystem;

// A double bubble that was run for four steps, with a frame and a .vtp file every two.
class Pictures : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    made_ = std::make_unique<ScratchFolder>();
    const ProgramResult run = run_foamsim(
        "run doublebubble --set n=8 --steps 4 --set frame_every=2 --set vtp=true --quiet --out " + (*made_ / "run"));
    ASSERT_EQ(run.exit_code, 0) << run.error;
  }
  static void TearDownTestSuite() { made_.reset(); }

  static std::string run() { return *made_ / "run"; }
  ProgramResult render(const std::string& arguments, const std::string& frame = "frames/frame_000004.ply") {
    return run_foamsim("render " + run() + "/" + frame + " --size 48x36 --samples 4 --out " + (scratch_ / "pictures") +
                       " " + arguments);
  }
  std::string picture(const std::string& arguments, const std::string& frame = "frames/frame_000004.ply") {
    const ProgramResult result = render(arguments, frame);
    EXPECT_EQ(result.exit_code, 0) << result.error;
    return read_file(scratch_.path() / "pictures/frame_000004.png");
  }
  void expect_refused(const ProgramResult& result, const std::string& part) {
    EXPECT_EQ(result.exit_code, 2) << part;
    EXPECT_EQ(std::ranges::count(result.error, '\n'), 1) << result.error;
    EXPECT_NE(result.error.find(part), std::string::npos) << result.error;
  }

  ScratchFolder scratch_;

 private:
  static std::unique_ptr<ScratchFolder> made_;
};
std::unique_ptr<ScratchFolder> Pictures::made_;

TEST_F(Pictures, AreChangedByEveryOption) {
  const std::string plain = picture("");
  for (const char* option :
       {"--background white", "--background transparent", "--view 0 0 1", "--zoom 2", "--eye 0 1 9", "--target 0.5 0 0",
        "--color regions", "--color pressure", "--cut 0 0 1 0", "--explode 0.5", "--scale-bar", "--wireframe",
        "--tube-radius 0.03", "--thickness 600", "--iridescence 1"})
    EXPECT_NE(picture(option), plain) << option;
  EXPECT_NE(picture("--color regions --opacity 0.9"), picture("--color regions"));
  EXPECT_NE(picture("--color pressure --range 0 10"), picture("--color pressure --range 0 2"));
}

TEST_F(Pictures, AreColouredByTheFieldsOfAFile) {
  const std::string vtp = "vtp/frame_000004.vtp";
  EXPECT_NE(picture("--color circulation", vtp), picture("", vtp));
}

TEST_F(Pictures, AreTakenFromAllSides) {
  const ProgramResult result = render("--turntable 3");
  ASSERT_EQ(result.exit_code, 0) << result.error;
  const auto side = [this](const char* name) { return read_file(scratch_.path() / "pictures" / name); };
  EXPECT_NE(side("frame_000004_000.png"), side("frame_000004_001.png"));
  EXPECT_FALSE(side("frame_000004_002.png").empty());
}

TEST_F(Pictures, RefuseWhatCannotBeDrawn) {
  expect_refused(render("--color teperature"), "no field 'teperature' to colour by; there are regions (no field)");
  expect_refused(render("--range 1 2"), "which --color has to name");
  expect_refused(render("--color pressure --range 2 1"), "the lower first");
  expect_refused(render("--cut 0 0 0 1"), "--cut has to be a direction");
  expect_refused(render("--cut 0 0 1 -9"), "nothing of the surface lies behind");
  expect_refused(render("--zoom 0"), "--zoom");
  expect_refused(render("--explode -1"), "--explode");
  expect_refused(render("--opacity 1"), "--opacity");
  expect_refused(render("--turntable 0"), "--turntable");
  expect_refused(render("--eye 1 1 1 --target 1 1 1"), "eye and target");
  EXPECT_FALSE(fs::exists(scratch_.path() / "pictures"));
}

// A stand-in for ffmpeg that knows one encoder, counts the pictures and writes that, or fails.
class Movie : public Pictures {
 protected:
  void SetUp() override {
    fs::create_directories(scratch_.path() / "bin");
    std::ofstream(scratch_.path() / "bin/ffmpeg") << R"(#!/bin/sh
case "$*" in
*-encoders*) printf ' V..... = Video\n ------\n V....D libx264  H.264\n V....D broken  B\n A....D aac  AAC\n'; exit ;;
*broken*) echo "the encoder broke" >&2; exit 1 ;;
esac
while [ "$#" -gt 1 ]; do
  [ "$1" = -i ] && pictures=$(dirname "$2")
  [ "$1" = -framerate ] && rate=$2
  shift
done
ls "$pictures" | grep -c png > "$1"
echo "$rate" >> "$1"
)";
    fs::permissions(scratch_.path() / "bin/ffmpeg", fs::perms::owner_all);
  }
  ProgramResult movie(const std::string& arguments) {
    return run_foamsim("movie " + run() + " " + arguments + " --size 32x24 --samples 1 --quiet",
                       "TMPDIR=" + scratch_.path().string() + " PATH=" + (scratch_ / "bin") + ":$PATH");
  }
  std::size_t files_left() {
    return static_cast<std::size_t>(std::distance(fs::directory_iterator(scratch_.path()), {}));
  }
};

TEST_F(Movie, IsMadeOfAllFramesAndLeavesNothingElse) {
  const ProgramResult result = movie((scratch_ / "film.mp4") + " --fps 12.5 --turn 90");
  ASSERT_EQ(result.exit_code, 0) << result.error;
  EXPECT_EQ(read_file(scratch_.path() / "film.mp4"), "3\n12.5\n");
  EXPECT_EQ(files_left(), 2u);  // bin and the film
}

TEST_F(Movie, RefusesWhatFfmpegCannotDo) {
  const std::string film = scratch_ / "film.mp4";
  expect_refused(movie(film + " --codec libx999"), "ffmpeg has no encoder 'libx999'");
  expect_refused(movie(film + " --codec aac"), "ffmpeg has no encoder 'aac'");
  expect_refused(movie(film + " --codec broken"), "the encoder broke");
  expect_refused(movie((scratch_ / "film.avx")), ".mp4, .mov, .mkv, .webm, .gif");
  expect_refused(movie((scratch_ / "nowhere/film.mp4")), "no such folder");
  expect_refused(movie(film + " --fps 0"), "--fps");
  expect_refused(movie(film + " --background transparent"), "films have a background");
  expect_refused(movie(film + " --color heat"), "no field 'heat'");
  EXPECT_EQ(files_left(), 1u);
}

TEST_F(Movie, SaysWhatIsMissing) {
  expect_refused(run_foamsim("movie " + run() + " " + (scratch_ / "film.mp4"), "PATH=/nowhere"),
                 "films need ffmpeg, which is not found in PATH: on Debian, `apt install ffmpeg`");
  expect_refused(run_foamsim("movie " + scratch_.path().string() + " film.mp4"), "no folder of a run");
  expect_refused(run_foamsim("movie " + run() + " " + (scratch_ / "film.mp4") + " --size 31x24"), "have to be even");
}

TEST_F(Movie, IsOneThatFfmpegReadsAgain) {
  if (std::system("command -v ffmpeg >/dev/null && command -v ffprobe >/dev/null") != 0)
    GTEST_SKIP() << "ffmpeg is not installed";
  for (const char* ending : {".mp4", ".webm", ".gif"}) {
    const std::string film = scratch_ / "film" + std::string(ending);
    const ProgramResult result = run_foamsim("movie " + run() + " " + film + " --size 64x48 --samples 1");
    ASSERT_EQ(result.exit_code, 0) << result.error;
    const ProgramResult probe = ::test::run_program(
        "ffprobe", "-v error -count_frames -show_entries stream=nb_read_frames,width,height -of csv=p=0 " + film);
    EXPECT_TRUE(probe.out.starts_with("64,48,3")) << ending << ": " << probe.out << probe.error;
  }
}

}  // namespace
}  // namespace foamsim::test
