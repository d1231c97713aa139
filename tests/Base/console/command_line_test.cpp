// How a command line is read, and what a user is told whose words cannot be.
#include "Base/console/command_line.h"

#include <gtest/gtest.h>

#include "Base/error.h"

namespace base {
namespace {

// A program with a command of each kind of argument, and what they were given.
struct Kitchen {
  CommandLine line{"kitchen", "cooks", "1.2.3"};
  std::string dish, oven = "gas", done;
  std::optional<long> minutes;
  std::optional<double> degrees;
  int portions = 4;
  bool quiet = false, quick = false;
  std::vector<std::string> spices{"salt"}, settings, plates;
  std::vector<long> sizes;
  std::vector<double> place{0, 0, 0};

  Kitchen() {
    Command& cook = line.root().add_command("cook", "makes a dish");
    cook.add({.name = "dish", .target = &dish, .help = "what to cook", .required = true});
    cook.add({.name = "--minutes", .target = &minutes, .help = "how long"});
    cook.add({.name = "--degrees", .target = &degrees, .help = "how hot"});
    cook.add({.name = "--portions", .target = &portions, .help = "for how many"});
    cook.add({.name = "--oven", .target = &oven, .help = "which", .names = {"gas", "wood"}, .names_only = true});
    cook.add({.name = "--quiet", .target = &quiet, .help = "says nothing"});
    cook.add({.name = "--quick", .target = [this] { quick = true; }, .help = "at once", .excludes = {"--minutes"}});
    cook.add({.name = "--spices", .target = &spices, .help = "some"});
    cook.add({.name = "--sizes", .target = &sizes, .help = "some"});
    cook.add({.name = "--place", .target = &place, .help = "X Y Z", .list = Argument::List::words, .count = 3});
    cook.add({.name = "--set", .target = &settings, .help = "key=value", .list = Argument::List::words});
    cook.set_action([this] {
      done = "cook";
      return 7;
    });
    Command& wash = line.root().add_command("wash", "cleans up");
    Command& plates_command = wash.add_command("plates", "the plates");
    plates_command.add(
        {.name = "plates", .target = &plates, .help = "which", .required = true, .list = Argument::List::words});
    plates_command.set_action([this] {
      done = "wash plates";
      return 0;
    });
  }

  int run(std::vector<const char*> words) {
    words.insert(words.begin(), "kitchen");
    return line.run(static_cast<int>(words.size()), words.data());
  }

  std::string refusal(const std::vector<const char*>& words) {
    try {
      run(words);
    } catch (const InputError& error) {
      EXPECT_EQ(done, "");
      return error.what();
    }
    return "not refused";
  }
};

TEST(CommandLine, ReadsEveryKindOfArgument) {
  Kitchen kitchen;
  EXPECT_EQ(
      kitchen.run({"cook", "--minutes", "5", "soup", "--degrees=1e2", "--portions", "-2", "--oven", "wood", "--quiet"}),
      7);
  EXPECT_EQ(kitchen.dish, "soup");
  EXPECT_EQ(kitchen.minutes, 5);
  EXPECT_EQ(kitchen.degrees, 100.0);
  EXPECT_EQ(kitchen.portions, -2);
  EXPECT_EQ(kitchen.oven, "wood");
  EXPECT_TRUE(kitchen.quiet);
  EXPECT_FALSE(kitchen.quick);
}

TEST(CommandLine, KeepsDefaultsOfWhatIsNotGiven) {
  Kitchen kitchen;
  kitchen.run({"cook", "soup", "--quick"});
  EXPECT_TRUE(kitchen.quick);
  EXPECT_EQ(kitchen.portions, 4);
  EXPECT_EQ(kitchen.spices, std::vector<std::string>{"salt"});
  EXPECT_FALSE(kitchen.minutes.has_value());
}

TEST(CommandLine, ListsAreSeparatedByCommasAndTakeNoOtherWord) {
  Kitchen kitchen;
  kitchen.run({"cook", "--spices", "pepper,mace", "soup", "--sizes", "1,2", "--sizes", "3"});
  EXPECT_EQ(kitchen.dish, "soup");
  EXPECT_EQ(kitchen.spices, (std::vector<std::string>{"pepper", "mace"}));
  EXPECT_EQ(kitchen.sizes, (std::vector<long>{1, 2, 3}));
}

TEST(CommandLine, ListsOfWordsKeepCommas) {
  Kitchen kitchen;
  kitchen.run({"cook", "soup", "--set", "a=1,2", "--set", "b=3", "--place", "1", "-2", "0.5"});
  EXPECT_EQ(kitchen.settings, (std::vector<std::string>{"a=1,2", "b=3"}));
  EXPECT_EQ(kitchen.place, (std::vector<double>{1, -2, 0.5}));
}

TEST(CommandLine, CommandsWithinCommandsTakeAsManyWordsAsThereAre) {
  Kitchen kitchen;
  EXPECT_EQ(kitchen.run({"wash", "plates", "one", "two"}), 0);
  EXPECT_EQ(kitchen.plates, (std::vector<std::string>{"one", "two"}));
}

TEST(CommandLine, SaysWhatWouldBeRight) {
  const std::vector<std::pair<std::vector<const char*>, std::string>> cases{
      {{}, "'kitchen' needs a command: cook, wash (see 'kitchen --help')"},
      {{"cok"}, "unknown command 'cok'; did you mean 'cook'? (known: cook, wash)"},
      {{"wash"}, "'kitchen wash' needs a command: plates (see 'kitchen wash --help')"},
      {{"wash", "plate"}, "unknown wash 'plate'; did you mean 'plates'? (known: plates)"},
      {{"-v"}, "unknown option '-v'; did you mean '--version'? (see 'kitchen --help')"},
      {{"cook", "--minuts", "5", "soup"},
       "unknown option '--minuts'; did you mean '--minutes'? (see 'kitchen cook --help')"},
      {{"cook", "--spcies=mace", "soup"},
       "unknown option '--spcies'; did you mean '--spices'? (see 'kitchen cook --help')"},
      {{"cook", "soup", "cake"}, "'cake' is a word too many; 'kitchen cook' takes dish (see 'kitchen cook --help')"},
      {{"cook"}, "'kitchen cook' needs 'dish': what to cook (see 'kitchen cook --help')"},
      {{"cook", "soup", "--minutes"}, "--minutes needs a value: N (see 'kitchen cook --help')"},
      {{"cook", "soup", "--place", "1", "2"}, "--place needs a value: X X X (see 'kitchen cook --help')"},
      {{"cook", "soup", "--minutes", "long"}, "--minutes: 'long' is not a whole number"},
      {{"cook", "soup", "--portions", "99999999999"}, "--portions: 99999999999 is too large"},
      {{"cook", "soup", "--minutes", "1", "--minutes", "2"}, "--minutes is given more than once: 1, 2"},
      {{"cook", "soup", "--oven", "wod"}, "--oven: unknown word 'wod'; did you mean 'wood'? (known: gas, wood)"},
      {{"cook", "soup", "--quick", "--minutes", "1"},
       "--quick cannot be given together with --minutes (see 'kitchen cook --help')"},
  };
  for (const auto& [words, message] : cases) EXPECT_EQ(Kitchen().refusal(words), message);
}

std::string printed(const std::vector<const char*>& words) {
  testing::internal::CaptureStdout();
  EXPECT_EQ(Kitchen().run(words), 0);
  return testing::internal::GetCapturedStdout();
}

TEST(CommandLine, PrintsHelpAndVersion) {
  EXPECT_EQ(printed({"--version"}), "1.2.3\n");
  const std::string all = printed({"--help"}), cook = printed({"cook", "-h"});
  for (const char* part : {"cooks", "cook", "makes a dish", "wash"})
    EXPECT_NE(all.find(part), std::string::npos) << part;
  for (const char* part : {"kitchen cook", "--minutes N", "--portions N=4", "how hot", "--oven NAME=gas"})
    EXPECT_NE(cook.find(part), std::string::npos) << part << "\n" << cook;
}

TEST(CommandLine, HiddenCommandsAreDoneButNotNamed) {
  Kitchen kitchen;
  Command& secret = kitchen.line.root().add_command("secret", "not for all");
  secret.hide();
  secret.set_action([] { return 3; });
  EXPECT_EQ(kitchen.run({"secret"}), 3);
  testing::internal::CaptureStdout();
  kitchen.run({"--help"});
  EXPECT_EQ(testing::internal::GetCapturedStdout().find("secret"), std::string::npos);
}

}  // namespace
}  // namespace base
