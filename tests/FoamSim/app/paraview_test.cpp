// What runs write for ParaView, as VTK's own readers find it.
#include <gtest/gtest.h>

#include <cstdlib>

#include "program.h"

namespace foamsim::test {
namespace {

namespace fs = std::filesystem;

bool has_vtk() {
  return std::system("/usr/bin/python3 -c 'import vtkmodules.vtkIOXML' >/dev/null 2>&1") == 0;
}

TEST(ParaView, VtkReadsFieldsUnitsAndBordersOfADoubleBubble) {
  if (!has_vtk()) GTEST_SKIP() << "python3-vtk9 is not installed";
  const ScratchFolder scratch;
  ASSERT_EQ(run_foamsim("run doublebubble --set n=12 --set frame_every=2 --steps 4 --fields all --quiet --out " +
                        (scratch / "double"))
                .exit_code,
            0);
  ASSERT_EQ(run_foamsim("run mode --set n=3 --set amplitude=0 --steps 1 --fields "
                        "film,mean_curvature,pressure_jump --quiet --out " +
                        (scratch / "ball"))
                .exit_code,
            0);
  const std::string command = "/usr/bin/python3 " FOAMSIM_PARAVIEW_SCRIPT " " + (scratch / "double") + " " +
                              (scratch / "ball") + " >" + (scratch / "log") + " 2>&1";
  EXPECT_EQ(std::system(command.c_str()), 0) << read_file(scratch / "log");
}

TEST(ParaView, FramesAreStartMeshesAndCanBeInspected) {
  const ScratchFolder scratch;
  ASSERT_EQ(run_foamsim("run doublebubble --steps 1 --set vtp=true --quiet --out " + (scratch / "run")).exit_code, 0);
  const std::string frame = scratch / "run/vtp/frame_000001.vtp";
  const ProgramResult inspected = run_foamsim("inspect " + frame);
  EXPECT_EQ(inspected.exit_code, 0) << inspected.out << inspected.error;
  EXPECT_EQ(run_foamsim("run " + frame + " --steps 1 --quiet --out " + (scratch / "next")).exit_code, 0);
}

TEST(ParaView, UnknownFieldsAreRefusedWithWhatThereIs) {
  const ScratchFolder scratch;
  const ProgramResult result =
      run_foamsim("run sphere --set n=1 --steps 1 --fields film,colour --out " + (scratch / "run"));
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_NE(result.error.find("there is no field 'colour' in this scene; there are: all, film, circulation"),
            std::string::npos)
      << result.error;
  EXPECT_FALSE(fs::exists(scratch.path() / "run"));
}

}  // namespace
}  // namespace foamsim::test
