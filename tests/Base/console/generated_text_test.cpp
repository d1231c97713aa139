// Completion scripts and manual pages: what they hold, and that the shells and troff take them.
#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>

#include "Base/console/manual_page.h"
#include "Base/console/shell_completion.h"
#include "tests/support/run_program.h"

namespace base {
namespace {

struct SmallKitchen {
  CommandLine line{"kitchen", "cooks", "1.2.3"};
  std::string dish, oven, out;
  std::vector<std::string> spices, settings;
  bool quick = false;

  SmallKitchen() {
    Command& cook = line.root().add_command("cook", "makes a dish: soup, [cake] or it's burnt");
    cook.add({.name = "dish", .target = &dish, .help = "what to cook", .names = {"soup", "cake"}});
    cook.add({.name = "--oven", .target = &oven, .help = "which", .names = {"gas", "wood"}});
    cook.add({.name = "--spices", .target = &spices, .help = "some", .names = {"mace", "marjoram", "salt"}});
    cook.add({.name = "--out", .target = &out, .help = "where to", .offers = Argument::Offers::folders});
    cook.add({.name = "--set",
              .target = &settings,
              .help = "key=value",
              .list = Argument::List::words,
              .assigns = {flag("lid.closed", true, "a flag"), whole_number("stirs", 3, 0, "a number, -1 is right")}});
    cook.add({.name = "--quick", .target = &quick, .help = "at once"});
    cook.set_action([] { return 0; });
    Command& wash = line.root().add_command("wash", "cleans up");
    wash.add_command("plates", "the plates").set_action([] { return 0; });
    Command& secret = line.root().add_command("secret", "not for all");
    secret.hide();
    secret.set_action([] { return 0; });
  }
};

bool has_program(const std::string& program) {
  return std::system(("command -v " + program + " >/dev/null").c_str()) == 0;
}

// What bash would offer at the end of the typed text.
std::string offered(const std::string& typed) {
  const test::ScratchFolder scratch;
  const SmallKitchen kitchen;
  std::ofstream(scratch / "script") << bash_completion(kitchen.line)
                                    << "COMP_LINE='" + typed +
                                           "'; COMP_POINT=${#COMP_LINE}; _kitchen; "
                                           "echo \"${COMPREPLY[*]}\"\n";
  const test::ProgramResult result = test::run_program("bash", scratch / "script");
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_EQ(result.error, "");
  return result.out.substr(0, result.out.find('\n'));
}

TEST(BashCompletion, OffersCommandsOptionsAndTheirWords) {
  const std::vector<std::pair<std::string, std::string>> cases{
      {"kitchen ", "cook wash"},
      {"kitchen c", "cook"},
      {"kitchen wash ", "plates"},
      {"kitchen --", "--help --version"},
      {"kitchen cook --", "--help --oven --spices --out --set --quick"},
      {"kitchen cook s", "soup"},
      {"kitchen cook --oven ", "gas wood"},
      {"kitchen cook --oven=w", "wood"},
      {"kitchen cook soup --spices ma", "mace marjoram"},
      {"kitchen cook soup --spices salt,mac", "salt,mace"},
      {"kitchen cook soup --set ", "lid.closed= stirs="},
      {"kitchen cook soup --set lid.closed=", "true false"},
      {"kitchen cook soup --set lid.closed=f", "false"},
      {"kitchen nothing ", "cook wash"},
  };
  for (const auto& [typed, words] : cases) EXPECT_EQ(offered(typed), words) << typed;
}

TEST(ZshCompletion, NamesWhatThereIsAndIsTakenByZsh) {
  const SmallKitchen kitchen;
  const std::string script = zsh_completion(kitchen.line);
  for (const char* part :
       {"#compdef kitchen", "_kitchen_wash_plates", "--oven[which]:value:(gas wood)", "lid.closed[a flag]"})
    EXPECT_NE(script.find(part), std::string::npos) << part << script;
  EXPECT_EQ(script.find("secret"), std::string::npos);
  if (!has_program("zsh")) GTEST_SKIP() << "zsh is not installed";
  const test::ScratchFolder scratch;
  std::ofstream(scratch / "_kitchen") << script;
  const test::ProgramResult result = test::run_program("zsh", "-n " + (scratch / "_kitchen"));
  EXPECT_EQ(result.exit_code, 0) << result.error;
}

TEST(ManualPage, SaysEverythingAndIsTakenByTroff) {
  const SmallKitchen kitchen;
  const std::string page =
      manual_page(kitchen.line,
                  {"Cooks.\n\n.Not a macro.", {{"option keys", manual_entries({flag("lid.closed", true, "a flag")})}}});
  for (const char* part : {".TH KITCHEN 1", "kitchen cook", "\\-\\-oven", "it's burnt", "lid.closed", ".SH OPTION KEYS",
                           "a flag (default: true)", "\\&.Not a macro."})
    EXPECT_NE(page.find(part), std::string::npos) << part << page;
  EXPECT_EQ(page.find("secret"), std::string::npos);
  if (!has_program("groff")) GTEST_SKIP() << "groff is not installed";
  const test::ScratchFolder scratch;
  std::ofstream(scratch / "kitchen.1") << page;
  const test::ProgramResult result = test::run_program("groff", "-man -Tascii -ww " + (scratch / "kitchen.1"));
  EXPECT_EQ(result.error, "");
}

}  // namespace
}  // namespace base
