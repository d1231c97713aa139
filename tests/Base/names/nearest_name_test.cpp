#include "Base/names/nearest_name.h"

#include <gtest/gtest.h>

#include <array>

namespace foamsim {
namespace {

constexpr std::array<std::string_view, 4> kKnown{"naive", "constant-edge", "averaged", "doublebubble"};

TEST(NearestName, FindsTyposOfEveryKind) {
  EXPECT_EQ(base::nearest_name("avergaed", kKnown), "averaged") << "swapped";
  EXPECT_EQ(base::nearest_name("averged", kKnown), "averaged") << "left out";
  EXPECT_EQ(base::nearest_name("averraged", kKnown), "averaged") << "doubled";
  EXPECT_EQ(base::nearest_name("avaraged", kKnown), "averaged") << "replaced";
  EXPECT_EQ(base::nearest_name("NAIVE", kKnown), "naive") << "capitals";
  EXPECT_EQ(base::nearest_name("constant_edge", kKnown), "constant-edge");
  EXPECT_EQ(base::nearest_name("double-bubble", kKnown), "doublebubble");
}

TEST(NearestName, DoesNotGuessWhenNothingIsNear) {
  EXPECT_EQ(base::nearest_name("zzzzzzzz", kKnown), "");
  EXPECT_EQ(base::nearest_name("anything", {}), "");
}

TEST(NearestName, ExactNamesAreNearest) {
  for (std::string_view name : kKnown) EXPECT_EQ(base::nearest_name(name, kKnown), name);
}

TEST(UnknownNameMessage, NamesKindNameSuggestionAndAllThatIsKnown) {
  EXPECT_EQ(
      base::unknown_name_message("area strategy", "naiv", kKnown),
      "unknown area strategy 'naiv'; did you mean 'naive'? (known: naive, constant-edge, averaged, doublebubble)");
  EXPECT_EQ(base::unknown_name_message("scene", "qqqqqqqqq", kKnown),
            "unknown scene 'qqqqqqqqq' (known: naive, constant-edge, averaged, doublebubble)");
}

TEST(UnknownNameMessage, SuggestsAFewOfManyNames) {
  std::vector<std::string> names{"remeshing.longest_edge", "remeshing.shortest_edge", "damping", "dampen", "dampind"};
  for (int i = 0; i < 20; ++i) names.push_back("some_other_option_" + std::to_string(i));
  const std::vector<std::string_view> known(names.begin(), names.end());
  EXPECT_EQ(base::unknown_name_message("option", "dampin", known),
            "unknown option 'dampin'; did you mean 'damping', 'dampen' or 'dampind'?");
  EXPECT_EQ(base::unknown_name_message("option", "longest_edge", known, "foamsim scenes"),
            "unknown option 'longest_edge'; did you mean 'remeshing.longest_edge'? (see 'foamsim scenes')");
}

// As long as the longest file of options; compared letter by letter it would take minutes.
TEST(NearestName, IsNotLookedForNearANameThatIsFarTooLong) {
  std::vector<std::string> names(400, "remeshing.longest_edge");
  const std::vector<std::string_view> known(names.begin(), names.end());
  // NOLINTNEXTLINE(bugprone-string-constructor): it is meant to be long.
  EXPECT_EQ(base::nearest_name(std::string(16'000'000, 'r'), known), "");
  EXPECT_EQ(base::nearest_name("remeshing.longest_edge" + std::string(11, 'e'), known), "remeshing.longest_edge");
}

}  // namespace
}  // namespace foamsim
