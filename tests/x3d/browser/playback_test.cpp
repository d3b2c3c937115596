#include <fstream>
#include <limits>
#include <sstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <pleura/fields/errors.h>
#include <pleura/tests/x3d/browser/load_scene.h>
#include <pleura/x3d/browser/playback/playback.h>

namespace pleura {
namespace {

using testing::ElementsAre;
using testing::SizeIs;

std::vector<std::string> linesOf(std::istream& in) {
  std::vector<std::string> lines;
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  return lines;
}

TEST(Keys, AreReadInOrderOfTime) {
  const auto keys = parseKeys(" 4.5:q\t2:p 2:r ");
  ASSERT_THAT(keys, SizeIs(3));
  EXPECT_EQ(keys[0].key + keys[1].key + keys[2].key, "prq") << "keys of one time keep their order";
  EXPECT_EQ(keys[2].time, 4.5);
  EXPECT_THAT(parseKeys(""), SizeIs(0));
}

TEST(Keys, WhatIsNoKeyAtATimeIsRefused) {
  for (const char* bad : {"p", "1:", ":p", "nan:p", "inf:p", "-1:p", "1x:p", "1 :p"})
    EXPECT_THROW(parseKeys(bad), std::invalid_argument) << bad;
}

TEST(Playback, TicksAtMultiplesOfTheStepUntilTheTimeInclusive) {
  const auto scene = sceneOf("<TimeSensor DEF='C' loop='true'/>");
  Playback playback(*scene, {.step = 0.1});
  std::vector<Time> times;
  playback.runUntil(0.3, [&](Time now) { times.push_back(now); });
  EXPECT_THAT(times, ElementsAre(0.0, 0.1, 2 * 0.1, 3 * 0.1));
  playback.runUntil(0.3, [&](Time now) { times.push_back(now); });
  EXPECT_THAT(times, SizeIs(4)) << "no time is ticked twice";
  EXPECT_EQ(playback.statistics().ticks(), 4u);
}

TEST(Playback, ManySmallStepsDoNotDrift) {
  const auto scene = sceneOf("<Group/>");
  Playback playback(*scene, {.step = 1e-3});
  playback.runUntil(100);
  EXPECT_EQ(playback.now(), 100000 * 1e-3);
}

TEST(Playback, KeysComeAtTheirTimes) {
  const auto scene = sceneOfABreath();
  Playback playback(*scene, {.step = 0.5, .keys = "1:p 2:P 3:x"});
  std::vector<bool> paused;
  playback.runUntil(3, [&](Time) { paused.push_back(valueOf<SFBool>(*scene, "BREATH.paused")); });
  EXPECT_THAT(paused, ElementsAre(false, false, true, true, false, false, false));
}

TEST(Playback, SettingsHoldFromTheFirstTick) {
  const auto scene = sceneOfABreath();
  Playback playback(*scene, {.set = {"BREATH.rate=30", "BREATH.depth=1"}});
  playback.runUntil(0);
  EXPECT_EQ(valueOf<SFFloat>(*scene, "BREATH.rate"), 30);
}

TEST(Playback, BadStepsAreRefused) {
  const auto scene = sceneOf("<Group/>");
  for (const double step : {0.0, -1.0, 1e-9, 1e9, std::numeric_limits<double>::quiet_NaN(),
                            std::numeric_limits<double>::infinity()})
    EXPECT_THROW(Playback(*scene, {.step = step}), std::invalid_argument) << step;
}

TEST(WatchTable, HasARowAStepAndAColumnAComponent) {
  const TemporaryFolder folder;
  const auto scene =
      sceneOf("<Transform DEF='T' translation='1 2.5 -3'/><WorldInfo DEF='W' title='say \"hi\", all'/>");
  const auto csv = folder.path() / "t.csv";
  {
    Playback playback(*scene, {.step = 0.5, .watch = {"T.translation", "T.visible", "W.title"}, .csv = csv});
    playback.runUntil(1);
  }
  std::ifstream in(csv);
  EXPECT_THAT(
      linesOf(in),
      ElementsAre("time,T.translation.0,T.translation.1,T.translation.2,T.visible,W.title",
                  "0,1,2.5,-3,true,\"say \"\"hi\"\", all\"", "0.5,1,2.5,-3,true,\"say \"\"hi\"\", all\"",
                  "1,1,2.5,-3,true,\"say \"\"hi\"\", all\""));
}

TEST(WatchTable, RefusesWhatHasNoNumbers) {
  const auto scene = sceneOf("<Group DEF='G'/><BooleanTrigger DEF='B'/>");
  EXPECT_THROW(WatchTable(*scene, {"G.children"}), FieldError);
  EXPECT_THROW(WatchTable(*scene, {"B.set_triggerTime"}), FieldAccessError);
  EXPECT_THROW(WatchTable(*scene, {"G.colour"}), UnknownNameError);
}

TEST(WatchTable, ACsvThatCannotBeWrittenIsRefused) {
  const auto scene = sceneOf("<Group DEF='G'/>");
  EXPECT_THROW(Playback(*scene, {.csv = "/no/such/folder/t.csv"}), FileError);
}

}  // namespace
}  // namespace pleura
