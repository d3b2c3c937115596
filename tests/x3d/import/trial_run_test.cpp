#include <csignal>
#include <stdexcept>
#include <thread>

#include <gtest/gtest.h>

#include <pleura/x3d/import/trial_run.h>

namespace pleura {
namespace {

TEST(TrialRun, TellsWhatBecameOfTheWork) {
  EXPECT_EQ(tryInChild([] {}, 10), Trial::finished);
  EXPECT_EQ(tryInChild([] { throw std::runtime_error("refused"); }, 10), Trial::finished);
  EXPECT_EQ(tryInChild([] { std::raise(SIGSEGV); }, 10), Trial::crashed);
  EXPECT_EQ(tryInChild([] { std::this_thread::sleep_for(std::chrono::seconds(60)); }, 1), Trial::hung);
}

TEST(TrialRun, LeavesThisProcessAsItWas) {
  int touched = 0;
  EXPECT_EQ(tryInChild([&] { touched = 1; }, 10), Trial::finished);
  EXPECT_EQ(touched, 0);
}

}  // namespace
}  // namespace pleura
