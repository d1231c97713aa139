#include "include_order.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>

namespace architecture {
namespace {

namespace fs = std::filesystem;

IncludeOrder order_of(const std::string& text) {
  std::istringstream lines(text);
  return IncludeOrder::read(lines);
}

const char* const house =
    "Base/error.h\n"
    "Base/io: Base/error.h\n"
    "Lib/mesh: Base\n"
    "Lib/moves: Lib/mesh\n"
    "Lib/pictures: Lib/mesh\n"
    "Lib/moves/fast: Lib/moves\n";

TEST(IncludeOrder, LetsSourcesSeeTheirOwnPlaceAndAllBelow) {
  const IncludeOrder order = order_of(house);
  EXPECT_FALSE(order.objection("Lib/moves/step.cpp", "Lib/moves/step.h"));
  EXPECT_FALSE(order.objection("Lib/moves/step.cpp", "Lib/mesh/mesh.h"));
  EXPECT_FALSE(order.objection("Lib/moves/step.cpp", "Base/error.h"));
  EXPECT_FALSE(order.objection("Lib/moves/fast/a.cpp", "Base/io/file.h"));
}

TEST(IncludeOrder, ObjectsToAnArrowUp) {
  const IncludeOrder order = order_of(house);
  const auto why = order.objection("Lib/mesh/mesh.h", "Lib/moves/step.h");
  ASSERT_TRUE(why);
  EXPECT_EQ(*why, "Lib/mesh/mesh.h includes Lib/moves/step.h: Lib/mesh does not stand on Lib/moves");
  EXPECT_TRUE(order.objection("Base/error.h", "Base/io/file.h"));
}

TEST(IncludeOrder, ObjectsToWhatStandsBeside) {
  EXPECT_TRUE(order_of(house).objection("Lib/pictures/a.cpp", "Lib/moves/step.h"));
}

TEST(IncludeOrder, AFolderWithinAPlaceIsAFloorOfItsOwnWhereTheListSaysSo) {
  const IncludeOrder order = order_of(house);
  EXPECT_EQ(order.place_of("Lib/moves/fast/a.h"), "Lib/moves/fast");
  EXPECT_EQ(order.place_of("Lib/moves/slow/a.h"), "Lib/moves");
  EXPECT_TRUE(order.objection("Lib/moves/step.cpp", "Lib/moves/fast/a.h"));
}

TEST(IncludeOrder, ObjectsToFilesOutsideOfTheList) {
  const IncludeOrder order = order_of(house);
  EXPECT_TRUE(order.objection("Lib/other/a.cpp", "Base/error.h"));
  EXPECT_TRUE(order.objection("Lib/mesh/mesh.cpp", "mesh.h"));
  EXPECT_EQ(order.place_of("Lib/meshes/a.h"), "");
}

TEST(IncludeOrder, CannotBeWrittenWithACircle) {
  EXPECT_THROW(order_of("a: b\nb: a\n"), std::runtime_error);
  EXPECT_THROW(order_of("a: a\n"), std::runtime_error);
  EXPECT_THROW(order_of("a\nb: a\na: b\n"), std::runtime_error);
}

TEST(IncludeOrder, ReadsTheIncludesOfASource) {
  std::istringstream source(
      "#include \"A/a.h\"\n// #include \"A/not.h\"\n#include <vector>\n#  include \"B/b.h\"  // why\n");
  EXPECT_EQ(quoted_includes(source), (std::vector<std::string>{"A/a.h", "B/b.h"}));
}

TEST(IncludeOrder, ReadsTheListOutOfAPage) {
  std::istringstream page("text\n```sh\nno\n```\n```order\na\nb: a\n```\nmore\n"), empty("text\n");
  EXPECT_EQ(fenced_order(page), "a\nb: a\n");
  EXPECT_THROW(fenced_order(empty), std::runtime_error);
}

class SourceTree : public ::testing::Test {
 protected:
  static IncludeOrder documented() {
    std::ifstream page(root() / "docs/architecture.md");
    std::istringstream lines(fenced_order(page));
    return IncludeOrder::read(lines);
  }
  static fs::path root() { return FOAMSIM_SOURCE_DIR; }
  static std::vector<std::string> sources() {
    std::vector<std::string> files;
    for (const char* folder : {"Base", "LosTopos", "MultiTracker", "FoamSim", "Python"})
      for (const fs::directory_entry& entry : fs::recursive_directory_iterator(root() / folder))
        if (entry.path().extension() == ".h" || entry.path().extension() == ".cpp")
          files.push_back(entry.path().lexically_relative(root()).generic_string());
    std::ranges::sort(files);
    return files;
  }
};

TEST_F(SourceTree, IncludesOnlyWhatIsBelow) {
  const IncludeOrder order = documented();
  const std::vector<std::string> files = sources();
  EXPECT_GT(files.size(), 300u);
  for (const std::string& file : files) {
    std::ifstream source(root() / file);
    for (const std::string& included : quoted_includes(source))
      if (const auto why = order.objection(file, included)) ADD_FAILURE() << *why;
  }
}

TEST_F(SourceTree, HasEveryPlaceOfTheList) {
  const IncludeOrder order = documented();
  std::vector<std::string> files = sources();
  files.emplace_back("FoamSim/version.h");  // generated
  for (const std::string& place : order.places())
    EXPECT_TRUE(std::ranges::any_of(files, [&](const std::string& file) { return order.place_of(file) == place; }))
        << place << " is in docs/architecture.md, but no source is there";
}

TEST_F(SourceTree, IsCoveredByTheList) {
  const IncludeOrder order = documented();
  for (const std::string& file : sources()) EXPECT_NE(order.place_of(file), "") << file;
}

}  // namespace
}  // namespace architecture
