#include "LosTopos/io/pvd.h"

#include <cmath>

#include "tests/LosTopos/io/io_test_tools.h"

namespace lostopos {
namespace {

class PvdTest : public IoTest {
 protected:
  std::string error_of(const std::string& content) {
    return input_error([&] { read_pvd(write("bad.pvd", content)); });
  }
};

TEST_F(PvdTest, RoundTrip) {
  const std::vector<PvdFrame> frames{{0, "frames/a.vtp"}, {0.1, "b & \"c\" <d>.vtp"}, {1e-300, "ü.vtp"}, {-1, "x"}};
  write_pvd(path("a.pvd"), frames);
  EXPECT_EQ(read_pvd(path("a.pvd")), frames);
  write_pvd(path("a.pvd"), {});
  EXPECT_TRUE(read_pvd(path("a.pvd")).empty());
}

TEST_F(PvdTest, GrowsFrameByFrameAndIsAlwaysWhole) {
  PvdWriter writer(path("a.pvd"));
  EXPECT_FALSE(std::filesystem::exists(path("a.pvd")));
  for (int i = 0; i < 5; ++i) {
    writer.add(0.25 * i, std::to_string(i) + ".vtp");
    EXPECT_EQ(read_pvd(path("a.pvd")), writer.frames());
    EXPECT_EQ(files_in_folder(), 1U);
  }
  PvdWriter resumed(path("a.pvd"), read_pvd(path("a.pvd")));
  resumed.add(9, "f9.vtp");
  EXPECT_EQ(read_pvd(path("a.pvd")).size(), 6U);
}

TEST_F(PvdTest, AFrameThatIsWrittenAnewIsListedOnce) {
  PvdWriter writer(path("a.pvd"));
  writer.add(0, "a.vtp");
  writer.add(1, "b.vtp");
  writer.add(1, "b.vtp");
  EXPECT_EQ(read_pvd(path("a.pvd")), (std::vector<PvdFrame>{{0, "a.vtp"}, {1, "b.vtp"}}));
  EXPECT_EQ(writer.frames(), read_pvd(path("a.pvd")));
}

TEST_F(PvdTest, FrameThatCannotBeWrittenIsNotAdded) {
  PvdWriter writer(path("a.pvd"));
  writer.add(0, "a.vtp");
  const std::string before = content_of(path("a.pvd"));
  EXPECT_THROW(writer.add(std::nan(""), "b.vtp"), base::InputError);
  EXPECT_THROW(writer.add(1, "b\x01.vtp"), base::InputError);
  EXPECT_THROW(writer.add(1, ""), base::InputError);
  EXPECT_EQ(writer.frames().size(), 1U);
  EXPECT_EQ(content_of(path("a.pvd")), before);
  PvdWriter nowhere(path("none/a.pvd"));
  EXPECT_THROW(nowhere.add(0, "a.vtp"), base::FileError);
  EXPECT_TRUE(nowhere.frames().empty());
}

TEST_F(PvdTest, Errors) {
  const std::string head = "<VTKFile type=\"Collection\">\n<Collection>\n", tail = "</Collection></VTKFile>";
  expect_contains(error_of(head + "<DataSet timestep=\"x\" file=\"a\"/>" + tail), "line 3: timestep is 'x'");
  expect_contains(error_of(head + "<DataSet timestep=\"nan\" file=\"a\"/>" + tail), "timestep is 'nan'");
  expect_contains(error_of(head + "<DataSet file=\"a\"/>" + tail), "no attribute 'timestep'");
  expect_contains(error_of(head + "<DataSet timestep=\"0\"/>" + tail), "no attribute 'file'");
  expect_contains(error_of(head + "<DataSet timestep=\"0\" file=\"&auml;\"/>" + tail), "entities");
  expect_contains(error_of(head + "<DataSet timestep=0/>" + tail), "not in quotes");
  expect_contains(error_of(head), "ends within");
  expect_contains(error_of("<VTKFile type=\"Collection\"/>"), "no element 'Collection'");
  expect_contains(error_of("<VTKFile type=\"PolyData\"/>"), "'Collection' is wanted");
  expect_contains(error_of(""), "no XML element");
  EXPECT_THROW(read_pvd(path("none.pvd")), base::FileError);
}

}  // namespace
}  // namespace lostopos
