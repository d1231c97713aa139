// What a user sees on a terminal: these tests make one.
#include "Base/console/terminal.h"

#include <gtest/gtest.h>
#include <pty.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <functional>

#include "Base/console/progress.h"

namespace base {
namespace {

// All that `show` writes to a terminal of so many columns.
std::string on_terminal(unsigned short columns, const std::function<void()>& show) {
  winsize size{24, columns, 0, 0};
  int terminal = -1;
  const pid_t child = forkpty(&terminal, nullptr, nullptr, &size);
  if (child == 0) {
    setenv("TERM", "xterm", 1);
    show();
    std::fflush(stderr);
    std::_Exit(0);
  }
  std::string text;
  char buffer[256];
  for (ssize_t count = 0; (count = read(terminal, buffer, sizeof(buffer))) > 0;)
    text.append(buffer, static_cast<std::size_t>(count));
  waitpid(child, nullptr, 0);
  close(terminal);
  return text;
}

TEST(Terminal, ErrorsAreColouredUnlessNoColorIsSet) {
  const std::string coloured = on_terminal(80, [] {
    unsetenv("NO_COLOR");
    print_error("kitchen", "burnt");
  });
  EXPECT_EQ(coloured, "\033[31mkitchen: burnt\033[0m\r\n");
  const std::string plain = on_terminal(80, [] {
    setenv("NO_COLOR", "1", 1);
    print_error("kitchen", "burnt");
    print_warning("kitchen", "hot");
  });
  EXPECT_EQ(plain, "kitchen: burnt\r\nkitchen: hot\r\n");
}

TEST(Terminal, OfAVeryLongMessageTheMiddleIsLeftOut) {
  const std::string shown = on_terminal(80, [] {
    setenv("NO_COLOR", "1", 1);
    std::string much;
    for (int i = 0; i < 100'000; ++i) much += "ü";
    print_error("kitchen", "x" + much + "burnt");
  });
  EXPECT_LT(shown.size(), 4100U);
  EXPECT_TRUE(shown.starts_with("kitchen: xüü"));
  EXPECT_TRUE(shown.ends_with("üüburnt\r\n"));
  EXPECT_NE(shown.find("ü … ü"), std::string::npos) << "cut between letters";
}

TEST(Terminal, TheProgressBarFitsInFortyColumns) {
  const std::string shown = on_terminal(40, [] {
    Progress progress("doublebubble", false);
    for (long step = 0; step < 4; ++step) {
      usleep(110000);
      progress.show(step, 123.45, 0.25 * static_cast<double>(step));
    }
  });
  EXPECT_EQ(shown.find('\n'), std::string::npos);
  std::size_t lines = 0;
  for (std::size_t at = shown.find("\033[K"); at != std::string::npos; at = shown.find("\033[K", at + 1)) {
    const std::size_t end = std::min(shown.find('\r', at), shown.size());
    EXPECT_LT(end - at - 3, 40U) << shown;
    ++lines;
  }
  EXPECT_GE(lines, 4U);
}

}  // namespace
}  // namespace base
