#include "Base/console/interrupt_guard.h"

#include <gtest/gtest.h>

namespace base {
namespace {

TEST(InterruptGuard, TellsWhichSignalCame) {
  for (const auto& [signal, code] : {std::pair{SIGINT, 130}, {SIGTERM, 143}, {SIGHUP, 129}}) {
    const InterruptGuard guard;
    EXPECT_FALSE(InterruptGuard::interrupted());
    std::raise(signal);
    EXPECT_TRUE(InterruptGuard::interrupted());
    EXPECT_EQ(InterruptGuard::exit_code(), code);
  }
}

TEST(InterruptGuard, ASecondSignalEndsTheProgram) {
  EXPECT_EXIT(
      {
        const InterruptGuard guard;
        std::raise(SIGTERM);
        std::raise(SIGTERM);
      },
      testing::KilledBySignal(SIGTERM), "");
}

TEST(InterruptGuard, PutsBackWhatWasThereAndLeavesAnIgnoredHangUpAlone) {
  std::signal(SIGHUP, SIG_IGN);
  {
    const InterruptGuard guard;
    std::raise(SIGHUP);
    EXPECT_FALSE(InterruptGuard::interrupted());
  }
  EXPECT_EQ(std::signal(SIGHUP, SIG_DFL), SIG_IGN);
  EXPECT_EQ(std::signal(SIGINT, SIG_DFL), SIG_DFL);
}

}  // namespace
}  // namespace base
