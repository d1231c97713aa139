#include "Base/options/option_set.h"

#include <gtest/gtest.h>

#include <limits>
#include <nlohmann/json.hpp>

#include "Base/error.h"
#include "Base/options/options_json.h"

namespace foamsim {
namespace {

using base::Words;

base::OptionSet example() {
  return base::OptionSet({base::positive_number("dt", 0.01, "step, T"),
                          base::non_negative_number("diffusion", 10, "rate, 1/T"),
                          base::whole_number("n", 16, 8, "subdivisions"),
                          base::flag("vtp", false, "ParaView"),
                          {"area", std::string("averaged"), "strategy", ""},
                          {"effects", Words{"surface_tension"}, "what acts", ""}});
}

template <class Action>
std::string message_of(Action&& action) {
  try {
    action();
  } catch (const base::InputError& error) {
    return error.what();
  }
  return "no InputError";
}

void expect_parts(const std::string& message, std::initializer_list<const char*> parts) {
  for (const char* part : parts) EXPECT_NE(message.find(part), std::string::npos) << part << " in: " << message;
}

TEST(OptionSetTest, StartsWithTheDefaultsAndRemembersWhatWasSet) {
  base::OptionSet options = example();
  EXPECT_EQ(options.number("dt"), 0.01);
  EXPECT_EQ(options.whole("n"), 16);
  EXPECT_FALSE(options.flag("vtp"));
  EXPECT_EQ(options.word("area"), "averaged");
  EXPECT_EQ(options.words("effects"), Words{"surface_tension"});
  EXPECT_FALSE(options.is_set("dt"));
  options.set_text("dt", "0.01", "--set");
  EXPECT_TRUE(options.is_set("dt")) << "also when it is the default";
  options.set_default("n", 24L);
  EXPECT_EQ(options.whole("n"), 24);
  EXPECT_FALSE(options.is_set("n"));
}

TEST(OptionSetTest, ReadsTextOfEveryKind) {
  base::OptionSet options = example();
  options.set_text("dt", " 5e-3 ", "--set");
  options.set_text("diffusion", "+2", "--set");
  options.set_text("n", "48", "--set");
  options.set_text("vtp", "on", "--set");
  options.set_text("area", "naive", "--set");
  options.set_text("effects", "surface_tension, damping", "--set");
  EXPECT_EQ(options.number("dt"), 0.005);
  EXPECT_EQ(options.number("diffusion"), 2);
  EXPECT_EQ(options.whole("n"), 48);
  EXPECT_TRUE(options.flag("vtp"));
  EXPECT_EQ(options.word("area"), "naive");
  EXPECT_EQ(options.words("effects"), (Words{"surface_tension", "damping"}));
}

TEST(OptionSetTest, Assignments) {
  base::OptionSet options = example();
  options.set_assignment("n=32", "--set");
  options.set_assignment("effects+=damping", "--set");
  options.set_assignment("effects+=damping,surface_tension", "--set");
  EXPECT_EQ(options.whole("n"), 32);
  EXPECT_EQ(options.words("effects"), (Words{"surface_tension", "damping"})) << "each once";
  options.set_assignment("area=a=b", "--set");
  EXPECT_EQ(options.word("area"), "a=b") << "the first = counts";
  options.set_assignment("effects=", "--set");
  EXPECT_TRUE(options.words("effects").empty());
}

TEST(OptionSetTest, WholeNumbersPassAsNumbersNotTheOtherWayRound) {
  base::OptionSet options = example();
  options.set("dt", 1L, "scene.toml:3");
  EXPECT_EQ(options.number("dt"), 1.0);
  expect_parts(message_of([&] { options.set("n", 16.0, "scene.toml:4"); }), {"scene.toml:4", "n", "a whole number"});
  options.set("effects", std::string("damping"), "");
  EXPECT_EQ(options.words("effects"), Words{"damping"});
}

TEST(OptionSetErrors, UnknownKeyComesWithPlaceAndSuggestion) {
  base::OptionSet options = example();
  expect_parts(message_of([&] { options.set_text("difusion", "1", "scene.toml:7"); }),
               {"scene.toml:7: ", "unknown option 'difusion'", "did you mean 'diffusion'?"});
  EXPECT_THROW(options.value("nothing"), base::InputError);
  EXPECT_THROW(options.set_default("nothing", 1.0), base::InputError);
}

TEST(OptionSetErrors, TextThatIsNotOfTheKind) {
  base::OptionSet options = example();
  for (const char* text : {"fast", "1e", "0.1x", "", "0x10", "1,5"})
    expect_parts(message_of([&] { options.set_text("dt", text, "--set"); }), {"--set: ", "dt", "a number"});
  for (const char* text : {"1.5", "many", "99999999999999999999"})
    expect_parts(message_of([&] { options.set_text("n", text, "--set"); }), {"--set: ", "n", "a whole number"});
  expect_parts(message_of([&] { options.set_text("vtp", "maybe", "--set"); }), {"vtp", "true or false"});
}

TEST(OptionSetErrors, ValuesThatAreNotAllowedSayWhatIs) {
  base::OptionSet options = example();
  for (const char* text : {"0", "-1", "inf", "nan"})
    expect_parts(message_of([&] { options.set_text("dt", text, "--set"); }),
                 {"--set: ", "dt = ", "a finite number > 0"});
  expect_parts(message_of([&] { options.set_text("n", "7", "scene.toml:2"); }),
               {"scene.toml:2: n = 7", "a whole number >= 8"});
  expect_parts(message_of([&] { options.set_text("diffusion", "-0.1", "--set"); }), {"a finite number >= 0"});
  options.set_text("diffusion", "0", "--set");
}

TEST(OptionSetErrors, NumbersMustBeFiniteEvenWhereNothingElseIsAsked) {
  base::OptionSet options({{"x", 0.0, "anything", ""}});
  for (const char* text : {"nan", "inf", "-inf"})
    expect_parts(message_of([&] { options.set_text("x", text, "--set"); }), {"--set: x = ", "finite"});
  options.set_text("x", "-7", "--set");
  EXPECT_EQ(options.number("x"), -7);
}

TEST(OptionSetErrors, LeaveTheValueAsItWas) {
  base::OptionSet options = example();
  options.set_text("dt", "0.5", "--set");
  EXPECT_THROW(options.set_text("dt", "-1", "--set"), base::InputError);
  EXPECT_THROW(options.set_text("dt", "x", "--set"), base::InputError);
  EXPECT_EQ(options.number("dt"), 0.5);
}

TEST(OptionSetErrors, ThePlaceIsNamedOnce) {
  base::OptionSet options = example();
  for (const char* text : {"x", "-1"}) {
    const std::string message = message_of([&] { options.set_text("dt", text, "--set"); });
    EXPECT_EQ(message.find("--set"), 0U) << message;
    EXPECT_EQ(message.find("--set", 1), std::string::npos) << message;
  }
}

TEST(OptionSetErrors, AssignmentsThatAreNone) {
  base::OptionSet options = example();
  for (const char* text : {"dt", "=3", ""})
    expect_parts(message_of([&] { options.set_assignment(text, "--set"); }), {"--set", "key=value"});
  expect_parts(message_of([&] { options.set_assignment("dt+=1", "--set"); }), {"dt", "a number", "for lists"});
  expect_parts(message_of([&] { options.set_assignment("+=1", "--set"); }), {"--set"});
}

TEST(Options, ForgetsWhatWasSet) {
  base::OptionSet options({base::whole_number("n", 3, 0, "a number")});
  options.set("n", 5L, "test");
  options.unset("n");
  EXPECT_EQ(options.whole("n"), 3);
  EXPECT_FALSE(options.is_set("n"));
}

TEST(OptionValueText, ReadsBackAsTheSame) {
  for (const base::OptionValue& value :
       {base::OptionValue(true), base::OptionValue(-42L), base::OptionValue(0.1), base::OptionValue(1.0 / 3),
        base::OptionValue(1e-300), base::OptionValue(std::string("averaged")), base::OptionValue(Words{"a", "b"}),
        base::OptionValue(Words{})})
    EXPECT_EQ(base::parse_option(base::to_text(value), value), value) << base::to_text(value);
}

TEST(OptionValueText, ListsMayHaveBracketsAndQuotes) {
  EXPECT_EQ(base::parse_option("[\"a\", \"b\"]", Words{}), base::OptionValue(Words{"a", "b"}));
  EXPECT_EQ(base::parse_option(" a ,b", Words{}), base::OptionValue(Words{"a", "b"}));
}

TEST(OptionValueKinds, ConvertOrThrow) {
  EXPECT_EQ(base::convert_option(3L, 0.5), base::OptionValue(3.0));
  EXPECT_THROW(base::convert_option(3.0, 1L), base::InputError);
  EXPECT_THROW(base::convert_option(true, 1L), base::InputError);
  EXPECT_THROW(base::convert_option(std::string("3"), 1.0), base::InputError);
  EXPECT_THROW(base::convert_option(Words{"a"}, std::string()), base::InputError);
}

// "auto" where numbers have to be > 0.
TEST(OptionSetTest, WordsMayStandForNumbers) {
  base::OptionSpec spec = base::positive_number("dt", 0.01, "step, T");
  spec.named_numbers = {{"auto", 0}};
  base::OptionSet options({spec});
  options.set_text("dt", "auto", "--set");
  EXPECT_EQ(options.number("dt"), 0);
  EXPECT_EQ(base::to_text(spec, options.value("dt")), "auto");
  EXPECT_EQ(base::to_text(spec, 0.5), "0.5");
  const nlohmann::json written = base::options_to_json(options);
  EXPECT_EQ(written.at("dt"), "auto");
  base::OptionSet read({spec});
  base::option_state_from_json(base::option_state_to_json(options), read);
  EXPECT_EQ(read.number("dt"), 0);
  EXPECT_TRUE(read.is_set("dt"));
  options.set("dt", std::string("auto"), "scene.toml:1");
  EXPECT_EQ(options.number("dt"), 0);
  expect_parts(message_of([&] { options.set_text("dt", "0", "--set"); }), {"--set", "dt = ", "> 0", "or auto"});
  expect_parts(message_of([&] { options.set_text("dt", "fast", "--set"); }), {"'fast' is not a number", "'auto'"});
}

TEST(OptionState, KeepsValuesAndWhatWasSet) {
  base::OptionSet options({base::positive_number("dt", 0.01, "step, T"), base::whole_number("n", 3, 1, "size")});
  options.set("n", 3L, "--set");
  options.set_default("dt", 0.5);
  base::OptionSet read(options.specs());
  base::option_state_from_json(base::option_state_to_json(options), read);
  EXPECT_EQ(read.number("dt"), 0.5);
  EXPECT_EQ(read.whole("n"), 3);
  EXPECT_FALSE(read.is_set("dt"));
  EXPECT_TRUE(read.is_set("n")) << "though at its default value";
}

TEST(OptionState, IsCheckedAsIfItWereGiven) {
  const base::OptionSet options(
      {base::non_negative_number("damping", 0, "rate, 1/T"), base::whole_number("n", 3, 1, "size")});
  const auto refused = [&](const nlohmann::json& state) {
    base::OptionSet read = options;
    return message_of([&] { base::option_state_from_json(state, read); });
  };
  const auto of = [](const char* key, const nlohmann::json& value, const char* set = "n") {
    nlohmann::json state = {{"values", {{"damping", 0.5}, {"n", 4}}}, {"set", {set}}};
    state["values"][key] = value;
    return state;
  };
  expect_parts(refused(of("damping", std::nan(""))), {"damping = nan", ">= 0"});
  expect_parts(refused(of("damping", -1.0)), {"damping = -1", ">= 0"});
  expect_parts(refused(of("n", 0)), {"n = 0", ">= 1"});
  expect_parts(refused(of("n", nlohmann::json::object())), {"n is not a list"});
  expect_parts(refused(of("n", 4.5)), {"n: '4.5' is not a whole number"});
  expect_parts(refused(of("dampign", 1.0)), {"dampign", "damping"});
  expect_parts(refused(of("n", 4, "m")), {"options.values has no 'm'"});
  expect_parts(refused(nlohmann::json(3)), {"options has no 'values'"});
  EXPECT_EQ(refused(of("n", 5)), "no InputError");
}

}  // namespace
}  // namespace foamsim
