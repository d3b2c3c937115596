#include <atomic>
#include <chrono>
#include <stdexcept>
#include <thread>

#include <gtest/gtest.h>

#include <pleura/nodes/deformable/job.h>
#include <pleura/tests/nodes/deformable/in_threads.h>

namespace pleura {
namespace {

/// True once `flag` is; false where nobody has set it for ten seconds.
bool comes(const std::atomic<bool>& flag) {
  using namespace std::chrono_literals;
  for (int k = 0; k < 10000 && !flag; ++k) std::this_thread::sleep_for(1ms);
  return flag;
}

class JobTest : public ::testing::TestWithParam<int> {
 protected:
  const InThreads threads_{GetParam()};
};

TEST_P(JobTest, IsDoneOnceForEachTimeItIsFinished) {
  int done = 0;
  Job job([&done] { ++done; });
  for (int k = 1; k <= 100; ++k) {
    if (k % 3 != 0) job.offer();
    job.offer();
    job.finish();
    ASSERT_EQ(done, k);
  }
}

TEST_P(JobTest, WhatIsThrownComesToWhoFinishesIt) {
  bool isBad = true;
  Job job([&isBad] {
    if (isBad) throw std::invalid_argument("bad");
  });
  job.offer();
  EXPECT_THROW(job.finish(), std::invalid_argument);
  isBad = false;
  EXPECT_NO_THROW(job.finish());
}

TEST_P(JobTest, WhatIsCancelledOrGoneIsNotDoneAfterwards) {
  int done = 0;
  {
    Job cancelled([&done] { ++done; });
    cancelled.offer();
    cancelled.cancel();
    const int before = done;
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
    EXPECT_EQ(done, before);
    cancelled.offer();
  }
  EXPECT_LE(done, 2);
}

INSTANTIATE_TEST_SUITE_P(Threads, JobTest, ::testing::Values(1, 2, 4));

TEST(Job, TwoAreDoneSideBySide) {
  const InThreads all(2);
  std::atomic<bool> isFirst = false, isSecond = false;
  bool sawSecond = false, sawFirst = false;
  Job first([&] {
    isFirst = true;
    sawSecond = comes(isSecond);
  });
  Job second([&] {
    isSecond = true;
    sawFirst = comes(isFirst);
  });
  first.offer();
  EXPECT_TRUE(comes(isFirst));  // a helper has it
  second.offer();
  first.finish();  // does the second meanwhile
  second.finish();
  EXPECT_TRUE(sawSecond);
  EXPECT_TRUE(sawFirst);
}

TEST(Job, WhatTakesNoTimeIsLeftToWhoNeedsIt) {
  const InThreads all(2);
  std::thread::id by;
  Job job([&by] { by = std::this_thread::get_id(); });
  job.finish();
  for (int k = 0; k < 10; ++k) {
    by = {};
    job.offer();
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
    EXPECT_EQ(by, std::thread::id());
    job.finish();
  }
}

TEST(Job, InOneThreadNothingIsDoneBeforeItIsNeeded) {
  const InThreads all(1);
  std::thread::id by;
  Job job([&by] { by = std::this_thread::get_id(); });
  job.offer();
  std::this_thread::sleep_for(std::chrono::milliseconds(5));
  EXPECT_EQ(by, std::thread::id());
  job.finish();
  EXPECT_EQ(by, std::this_thread::get_id());
}

}  // namespace
}  // namespace pleura
