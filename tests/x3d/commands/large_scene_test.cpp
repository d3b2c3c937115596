#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <pleura/tests/x3d/commands/run_program.h>
#include <pleura/tests/x3d/temporary_folder.h>

namespace pleura {
namespace {

using testing::HasSubstr;

std::string times(int count, std::string_view text) {
  std::string all;
  for (int i = 0; i < count; ++i) all += text;
  return all;
}

/// Scenes whose size is out of the common: what takes time as the square of it never ends.
class LargeScene : public testing::Test {
 protected:
  std::string write(const std::string& elements) const {
    return folder_.write("large.x3d", "<Scene>\n" + elements + "</Scene>");
  }

  TemporaryFolder folder_;
};

TEST_F(LargeScene, AMillionNodesRun) {
  EXPECT_EQ(runProgram({"run", write(times(1000000, "<Group/>\n")), "--for", "0.1"}).status, kDone);
}

TEST_F(LargeScene, AMillionFaultsAreCounted) {
  const Outcome outcome = runProgram({"check", write(times(1000000, "<Group USE='NOBODY'/>\n"))});
  EXPECT_EQ(outcome.status, kFault);
  EXPECT_THAT(outcome.output, HasSubstr("large.x3d:1001:"));
  EXPECT_THAT(outcome.output, HasSubstr("and 999000 more"));
}

TEST_F(LargeScene, AHundredThousandListenersComeAndGo) {
  const std::string each = "<KeySensor/><TimeSensor loop='true'/>\n";
  const std::string apart = times(100000, each);
  EXPECT_EQ(runProgram({"run", write(apart + "<Group>" + apart + "</Group>"), "--for", "0.1"}).status, kDone);
}

TEST_F(LargeScene, AHundredThousandAttributesAreAFault) {
  std::string element = "<Group ";
  for (int i = 0; i < 100000; ++i) element += fmt::format("a{}='' ", i);
  EXPECT_EQ(runProgram({"check", write(element + "/>")}).status, kFault);
}

TEST_F(LargeScene, WhatIsNestedTooDeepIsCutOff) {
  constexpr int kDeep = 100000;
  const std::string picture = folder_.path() / "x.png";
  for (const std::string type : {"Group", "Transform"}) {
    const std::string file =
        write(times(kDeep, "<" + type + ">") + "<Shape><Box/></Shape>" + times(kDeep, "</" + type + ">"));
    for (const auto& command : {std::vector<std::string>{"check", file},
                                {"run", file, "--for", "0.1"},
                                {"render", file, "-o", picture}}) {
      const Outcome outcome = runProgram(command);
      EXPECT_EQ(outcome.status, kFault) << command[0];
      EXPECT_THAT(outcome.output, HasSubstr("nested more than 1000 deep")) << command[0];
    }
  }
}

TEST_F(LargeScene, WhatIsNestedAsDeepAsAllowedIsDrawn) {
  constexpr int kDeep = 990;
  const std::string file = write(times(kDeep, "<Transform translation='0.001 0 0'>") +
                                 "<Shape><Box/></Shape>" + times(kDeep, "</Transform>"));
  EXPECT_EQ(runProgram({"render", file, "-o", folder_.path() / "x.png", "--size", "64x64"}).status, kDone);
}

}  // namespace
}  // namespace pleura
