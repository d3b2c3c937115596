#include <atomic>
#include <cstdlib>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <pleura/x3d/import/isolated_call.h>

namespace pleura {
namespace {

std::string errorOf(const std::function<std::string()>& work) {
  try {
    isolatedCall(work, 1);
  } catch (const IsolationError& error) {
    return error.what();
  }
  return "returned";
}

TEST(IsolatedCall, ReturnsWhatTheWorkReturned) {
  std::string large(3'000'000, '\0');
  for (std::size_t i = 0; i < large.size(); ++i) large[i] = static_cast<char>(i * i);
  EXPECT_EQ(isolatedCall([&large] { return large; }, 10), large);
  EXPECT_EQ(isolatedCall([] { return std::string(); }, 10), "");
}

TEST(IsolatedCall, LeavesTheCallersMemoryAlone) {
  int value = 1;
  EXPECT_EQ(isolatedCall([&value] { return std::to_string(value = 2); }, 10), "2");
  EXPECT_EQ(value, 1);
}

TEST(IsolatedCall, SaysHowTheWorkEnded) {
  EXPECT_EQ(errorOf([]() -> std::string { throw std::runtime_error("why"); }), "why");
  EXPECT_THAT(errorOf([]() -> std::string { std::abort(); }), testing::HasSubstr("crashed"));
  EXPECT_THAT(errorOf([]() -> std::string { _Exit(7); }), testing::HasSubstr("crashed"));
  const auto runForever = []() -> std::string {
    for (std::atomic<unsigned int> i = 0;;) ++i;
  };
  EXPECT_THAT(errorOf(runForever), testing::HasSubstr("took more than 1 s"));
}

}  // namespace
}  // namespace pleura
