#include "FoamSim/scenes/toml_scene.h"

#include <gtest/gtest.h>

#include <fstream>

#include "Base/error.h"
#include "tests/support/scratch_folder.h"

namespace foamsim {
namespace {

// Why the text, behind its first line, is no scene; empty, and a failure, where it is one.
std::string refusal_of_scene(const std::string& text) {
  const ::test::ScratchFolder scratch;
  std::ofstream(scratch / "scene.toml") << "scene = \"sphere\"\n" << text;
  try {
    read_toml_scene(scratch / "scene.toml", built_in_catalogue());
  } catch (const base::InputError& error) {
    return error.what();
  }
  ADD_FAILURE() << "accepted";
  return {};
}

std::string repeated(const std::string& text, int times) {
  std::string all;
  for (int i = 0; i < times; ++i) all += text;
  return all;
}

void expect_refusal(const std::string& text, const std::string& part) {
  const std::string message = refusal_of_scene(text);
  EXPECT_NE(message.find(part), std::string::npos) << message.substr(0, 1000);
}

// Each part of a key is a table within that of the part before: so many ended the program once.
TEST(TomlScene, AKeyOfVeryManyPartsIsRefused) {
  const std::string parts = repeated("a.", 200'000) + "a";
  const std::string message = "scene.toml:2: more than 255 dots in one line";
  expect_refusal(parts + " = 1\n", message);
  expect_refusal("[" + parts + "]\nb = 1\n", message);
  expect_refusal("[[" + parts + "]]\nb = 1\n", message);
  expect_refusal("b = {" + parts + " = 1}\n", message);
  expect_refusal(parts + " = 1\nno toml\n", message);
}

TEST(TomlScene, ValuesNestedVeryDeepAreRefused) {
  expect_refusal("a = " + repeated("[", 200'000) + repeated("]", 200'000) + "\n", "not valid TOML");
  // Nearly as deep as the parser goes, with a long key each time.
  const std::string key = repeated("a.", 250) + "a";
  expect_refusal("b = [\n" + repeated("{" + key + " = [\n", 120) + repeated("]}", 120) + "]\n", "scene.toml:");
}

TEST(TomlScene, TablesNestedDeeperThanAnyOptionAreRefused) {
  expect_refusal("a.b.c.d.e.f.g.h.i.j = 1\n", "scene.toml:2: tables are nested more than 8 deep");
  expect_refusal("remeshing.b.c = 1\n", "unknown option 'remeshing.b.c'");
}

TEST(TomlScene, AListOfManyNumbersMayTakeSeveralLines) {
  expect_refusal("dt = [" + repeated("0.5,\n", 300) + "]\n", "scene.toml:2: ");
  EXPECT_EQ(refusal_of_scene("dt = [" + repeated("0.5,\n", 300) + "]\n").find("dots"), std::string::npos);
}

}  // namespace
}  // namespace foamsim
