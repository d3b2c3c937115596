#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <pleura/tests/x3d/commands/run_program.h>
#include <pleura/tests/x3d/temporary_folder.h>

namespace pleura {
namespace {

using testing::HasSubstr;
using testing::Not;

/// The program says something and exits with this status.
void expectStatus(int status, const std::vector<std::string>& arguments) {
  std::string line = "pleura";
  for (const auto& argument : arguments) line += " " + argument;
  SCOPED_TRACE(line);
  const Outcome outcome = runProgram(arguments);
  EXPECT_EQ(outcome.status, status) << outcome.output;
  EXPECT_FALSE(outcome.output.empty());
  EXPECT_THAT(outcome.output, Not(HasSubstr("terminate called")));
}

class BadInput : public testing::Test {
 protected:
  std::string path(const char* name) const { return (folder_.path() / name).string(); }

  TemporaryFolder folder_;
  std::string good_ = folder_.write(
      "good.x3d",
      "<Scene><Viewpoint DEF='FRONT'/><Transform DEF='T'><Shape><Box/></Shape></Transform></Scene>");
  std::vector<std::string> notScenes_ = {
      path("missing.x3d"), folder_.path().string(), folder_.write("empty.x3d", ""),
      folder_.write("rubbish.x3d", std::string_view("\0\1\xff\xfe<<rubbish>>", 15)),
      folder_.write("truncated.x3d", "<Scene><Transform DEF='T'><Sha")};
};

TEST_F(BadInput, WhatIsNoSceneIsAFaultForEveryCommand) {
  for (const auto& file : notScenes_) {
    expectStatus(kFault, {"check", file});
    expectStatus(kFault, {"run", file, "--for", "0.1"});
    expectStatus(kFault, {"render", file, "-o", path("x.png")});
    expectStatus(kFault, {"play", file});
    expectStatus(kFault, {"convert", file, "-o", path("x.x3d")});
  }
}

TEST_F(BadInput, WhatIsNoMeshIsAFault) {
  folder_.write("rubbish.obj", "v nan\nf 1 2 99999999\n");
  folder_.write("rubbish.stl", std::string_view("\0\1\xff\xfe", 4));
  folder_.write("empty.ply", "");
  for (const char* name : {"rubbish.obj", "rubbish.stl", "empty.ply", "missing.obj"})
    expectStatus(kFault, {"convert", path(name), "-o", path("x.x3d")});
  expectStatus(kFault, {"anatomy", "--from", path("nowhere"), "-o", path("out")});
  expectStatus(kFault, {"anatomy", "--from", folder_.path().string(), "-o", path("out")});
}

TEST_F(BadInput, UnknownOptionsAndCommandsAreWrongUsage) {
  expectStatus(kUsage, {});
  expectStatus(kUsage, {"fly"});
  for (const char* command : {"check", "run", "render", "play", "convert", "anatomy", "nodes", "demo"})
    expectStatus(kUsage, {command, "--no-such-option"});
  for (const char* command : {"check", "run", "render", "play", "convert", "anatomy"})
    expectStatus(kUsage, {command});
}

TEST_F(BadInput, NumbersThatAreNoneAreWrongUsage) {
  for (const char* number : {"nan", "inf", "-1", "1e999", "x", ""}) {
    expectStatus(kUsage, {"run", good_, "--for", number});
    expectStatus(kUsage, {"run", good_, "--for", "0.1", "--step", number});
    expectStatus(kUsage, {"render", good_, "-o", path("x.png"), "--at", number});
    expectStatus(kUsage, {"render", good_, "-o", path("frames"), "--for", number});
    expectStatus(kUsage, {"render", good_, "-o", path("frames"), "--for", "0.1", "--fps", number});
    expectStatus(kUsage, {"convert", good_, "-o", path("x.x3d"), "--decimate", number});
    expectStatus(kUsage, {"convert", good_, "-o", path("x.x3d"), "--scale", number});
  }
  for (const char* size : {"nan", "0x0", "-1x5", "100", "99999999x99999999"})
    expectStatus(kUsage, {"render", good_, "-o", path("x.png"), "--size", size});
}

TEST_F(BadInput, KeysAndWatchesAndSettingsThatDoNotFit) {
  for (const char* keys : {"p", "nan:p", "-1:p", "1:", ":p"})
    expectStatus(kUsage, {"run", good_, "--for", "0.1", "--keys", keys});
  for (const char* watch : {"T", "NOBODY.translation", "T.translaton", "T.children", "."})
    expectStatus(kFault, {"run", good_, "--for", "0.1", "--watch", watch, "--csv", path("x.csv")});
  for (const char* set : {"T", "T.translation", "NOBODY.x=1", "T.translation=1 2", "T.translation=nan 0 0"})
    expectStatus(kFault, {"run", good_, "--for", "0.1", "--set", set});
}

TEST_F(BadInput, AMisspeltNameIsToldWithTheNearest) {
  EXPECT_THAT(runProgram({"run", good_, "--for", "0.1", "--set", "T.translaton=0 0 0"}).output,
              HasSubstr("did you mean translation?"));
  EXPECT_THAT(runProgram({"render", good_, "-o", path("x.png"), "--viewpoint", "FRNT"}).output,
              HasSubstr("did you mean FRONT?"));
  const Outcome type = runProgram({"nodes", "Transfrom"});
  EXPECT_EQ(type.status, kFault);
  EXPECT_THAT(type.output, HasSubstr("did you mean Transform?"));
}

TEST_F(BadInput, WhereNothingCanBeWrittenIsAFault) {
  const std::string nowhere = path("no/such/folder/x");
  expectStatus(kFault, {"run", good_, "--for", "0.1", "--watch", "T.translation", "--csv", nowhere + ".csv"});
  expectStatus(kFault, {"run", good_, "--for", "0.1", "--watch", "T.translation", "--csv", "/dev/full"});
  expectStatus(kFault, {"render", good_, "-o", nowhere + ".png"});
  expectStatus(kFault, {"render", good_, "-o", nowhere + ".mp4", "--for", "0.1", "--size", "64x64"});
  expectStatus(kFault, {"render", good_, "-o", good_ + "/below/a/file", "--for", "0.1"});
  expectStatus(kFault, {"convert", good_, "-o", "/dev/full"});
  expectStatus(kFault, {"demo", "-o", good_});
  expectStatus(kFault, {"convert", good_, "-o", nowhere + ".x3d"});
  expectStatus(kFault, {"anatomy", "-o", good_ + "/below/a/file"});
}

TEST_F(BadInput, AnOverlongOrStrangeNameIsAFault) {
  expectStatus(kFault, {"check", std::string(5000, 'x')});
  expectStatus(kFault, {"run", "\xff\xfe\n", "--for", "0.1"});
}

TEST_F(BadInput, NamesThatNothingHas) {
  expectStatus(kUsage, {"render", good_, "-o", path("x.png"), "--viewpoint", "NOWHERE"});
  expectStatus(kUsage, {"render", good_, "-o", path("x.png"), "--viewpoint", "T"});
  expectStatus(kUsage, {"run", good_, "--for", "0.1", "--anatomy", path("nowhere")});
  expectStatus(kFault, {"nodes", "--library", "nothing"});
}

TEST_F(BadInput, PlayWithoutADisplaySaysSo) {
  const Outcome outcome = runProgram({"play", good_});
  EXPECT_EQ(outcome.status, kFault);
  EXPECT_THAT(outcome.output, HasSubstr("no window: X11: The DISPLAY environment variable is missing"));
}

TEST_F(BadInput, AllFilesAreCheckedAndTheWorstCounts) {
  const Outcome outcome = runProgram({"check", good_, notScenes_[2], notScenes_[4]});
  EXPECT_EQ(outcome.status, kFault);
  EXPECT_THAT(outcome.output, HasSubstr("empty.x3d"));
  EXPECT_THAT(outcome.output, HasSubstr("truncated.x3d:1:"));
  EXPECT_THAT(outcome.output, HasSubstr("3 files:"));
}

TEST_F(BadInput, WarningsAreFaultsOnlyWhenStrict) {
  const std::string file = folder_.write("warned.x3d", "<Scene><Group colour='red'/></Scene>");
  expectStatus(kDone, {"check", file});
  expectStatus(kFault, {"check", "--strict", file});
}

TEST_F(BadInput, TheVersionIsThatOfProgramAndPlugins) {
  const Outcome outcome = runProgram({"--version"});
  EXPECT_EQ(outcome.status, kDone);
  EXPECT_THAT(outcome.output, testing::MatchesRegex("pleura [0-9]+\\.[0-9]+\\.[0-9]+, plugin ABI [0-9]+\n"));
}

TEST_F(BadInput, GoodInputIsDone) {
  EXPECT_EQ(runProgram({"run", good_, "--for", "0.1"}).status, kDone);
  expectStatus(kDone, {"run", good_, "--for", "0.1", "--hash"});
  expectStatus(kDone, {"--help"});
}

}  // namespace
}  // namespace pleura
