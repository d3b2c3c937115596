#include <gtest/gtest.h>

#include <pleura/nodes/standard/time/time_sensor.h>
#include <pleura/tests/nodes/test_context.h>

namespace pleura {
namespace {

class TimeSensorRules : public ::testing::Test {
 protected:
  std::shared_ptr<TimeSensor> make(Time start, Time interval, bool loop = false) {
    return context.make<TimeSensor>([&](TimeSensor& sensor) {
      sensor.startTime.setValue(start);
      sensor.cycleInterval.setValue(interval);
      sensor.loop.setValue(loop);
    });
  }
  TestContext context;
};

TEST_F(TimeSensorRules, WithDefaultsNeverRuns) {
  const auto sensor = context.make<TimeSensor>();
  Recorder<SFBool> active(sensor->isActive);
  for (const Time now : {0.0, 0.5, 1.0, 5.0}) context.tick(now);
  EXPECT_TRUE(active.values.empty());
}

TEST_F(TimeSensorRules, LoopingWithDefaultsRunsFromTheStart) {
  const auto sensor = make(0, 1, true);
  context.tick(0.25);
  EXPECT_TRUE(sensor->isActive.getValue());
  EXPECT_FLOAT_EQ(sensor->fraction_changed.getValue(), 0.25f);
}

TEST_F(TimeSensorRules, StartsWhenStartTimeIsReached) {
  const auto sensor = make(1, 2);
  Recorder<SFBool> active(sensor->isActive);
  context.tick(0.9);
  EXPECT_FALSE(sensor->isActive.getValue());
  context.tick(1.5);
  EXPECT_TRUE(sensor->isActive.getValue());
  EXPECT_DOUBLE_EQ(sensor->cycleTime.getValue(), 1);
  EXPECT_DOUBLE_EQ(sensor->elapsedTime.getValue(), 0.5);
  EXPECT_FLOAT_EQ(sensor->fraction_changed.getValue(), 0.25f);
  EXPECT_DOUBLE_EQ(sensor->time.getValue(), 1.5);
  context.tick(2);
  EXPECT_EQ(active.values, std::vector<bool>{true}) << "isActive is only sent when it changes";
}

TEST_F(TimeSensorRules, EndsItsCycleWithFractionOne) {
  const auto sensor = make(1, 0.3);
  context.tick(1.1);
  context.tick(7);
  EXPECT_FALSE(sensor->isActive.getValue());
  EXPECT_EQ(sensor->fraction_changed.getValue(), 1.0f);
  EXPECT_NEAR(sensor->elapsedTime.getValue(), 0.3, 1e-12);
  EXPECT_NEAR(sensor->time.getValue(), 1.3, 1e-12);
  context.tick(8);
  EXPECT_NEAR(sensor->time.getValue(), 1.3, 1e-12) << "nothing is sent once it has stopped";
}

TEST_F(TimeSensorRules, RunsACycleThatFallsBetweenTwoTicks) {
  const auto sensor = make(1, 0.25);
  context.tick(0.9);
  context.tick(2);
  EXPECT_FALSE(sensor->isActive.getValue());
  EXPECT_EQ(sensor->fraction_changed.getValue(), 1.0f);
  EXPECT_DOUBLE_EQ(sensor->cycleTime.getValue(), 1);
}

TEST_F(TimeSensorRules, IsOverWhenItWouldHaveEndedBeforeLoading) {
  context.tick(100);
  const auto sensor = make(10, 5);
  Recorder<SFTime> sent(sensor->time);
  context.tick(101);
  EXPECT_TRUE(sent.values.empty());
}

TEST_F(TimeSensorRules, JoinsACycleThatRunsWhileLoading) {
  context.tick(100);
  const auto sensor = make(99, 4);
  context.tick(101);
  EXPECT_TRUE(sensor->isActive.getValue());
  EXPECT_FLOAT_EQ(sensor->fraction_changed.getValue(), 0.5f);
  EXPECT_DOUBLE_EQ(sensor->elapsedTime.getValue(), 1) << "counted from when it became active";
}

TEST_F(TimeSensorRules, SendsCycleTimeAtTheBeginningOfEachCycle) {
  const auto sensor = make(1, 0.5, true);
  Recorder<SFTime> cycles(sensor->cycleTime);
  for (int i = 0; i <= 30; ++i) context.tick(0.1 * i);
  ASSERT_EQ(cycles.values.size(), 4u);
  for (std::size_t i = 0; i < cycles.values.size(); ++i)
    EXPECT_NEAR(cycles.values[i], 1 + 0.5 * static_cast<double>(i), 1e-12);
  EXPECT_EQ(sensor->fraction_changed.getValue(), 1.0f) << "at the end of a cycle the fraction is 1, not 0";
}

TEST_F(TimeSensorRules, StopsAtStopTime) {
  const auto sensor = make(1, 1, true);
  sensor->stopTime.setValue(2.25);
  context.tick(1);
  context.tick(2);
  EXPECT_TRUE(sensor->isActive.getValue());
  context.tick(3);
  EXPECT_FALSE(sensor->isActive.getValue());
  EXPECT_FLOAT_EQ(sensor->fraction_changed.getValue(), 0.25f);
  EXPECT_DOUBLE_EQ(sensor->elapsedTime.getValue(), 1.25);
}

TEST_F(TimeSensorRules, IgnoresAStopTimeNotAfterStartTime) {
  const auto sensor = make(1, 1, true);
  sensor->stopTime.setValue(1);
  context.tick(5);
  EXPECT_TRUE(sensor->isActive.getValue());
  sensor->stopTime.setValue(0.5);
  EXPECT_TRUE(sensor->isActive.getValue());
  EXPECT_EQ(sensor->stopTime.getValue(), 1) << "ignored while active";
}

TEST_F(TimeSensorRules, StopsAtOnceWhenStopTimeIsSetIntoThePast) {
  const auto sensor = make(1, 10, true);
  context.tick(4);
  sensor->stopTime.setValue(2);
  EXPECT_FALSE(sensor->isActive.getValue());
  EXPECT_DOUBLE_EQ(sensor->time.getValue(), 4) << "time never goes back";
}

TEST_F(TimeSensorRules, IgnoresStartTimeAndCycleIntervalWhileActive) {
  const auto sensor = make(1, 4, true);
  context.tick(2);
  sensor->startTime.setValue(2);
  sensor->cycleInterval.setValue(1);
  EXPECT_EQ(sensor->startTime.getValue(), 1);
  EXPECT_EQ(sensor->cycleInterval.getValue(), 4);
  context.tick(3);
  EXPECT_FLOAT_EQ(sensor->fraction_changed.getValue(), 0.5f);
}

TEST_F(TimeSensorRules, FinishesTheCycleWhenLoopIsSwitchedOff) {
  const auto sensor = make(1, 1, true);
  context.tick(3.5);
  sensor->loop.setValue(false);
  context.tick(3.75);
  EXPECT_TRUE(sensor->isActive.getValue());
  context.tick(4.5);
  EXPECT_FALSE(sensor->isActive.getValue());
  EXPECT_EQ(sensor->fraction_changed.getValue(), 1.0f);
  EXPECT_DOUBLE_EQ(sensor->elapsedTime.getValue(), 3);
}

TEST_F(TimeSensorRules, RunsAgainWhenStartTimeIsSetAfterTheEnd) {
  const auto sensor = make(1, 1);
  context.tick(1);
  context.tick(5);
  sensor->startTime.setValue(5);
  EXPECT_TRUE(sensor->isActive.getValue());
  EXPECT_EQ(sensor->fraction_changed.getValue(), 0.0f);
  context.tick(5.5);
  EXPECT_FLOAT_EQ(sensor->fraction_changed.getValue(), 0.5f);
}

TEST_F(TimeSensorRules, StartsAtTimeZeroWhenToldSoByAnEvent) {
  context.tick(0);
  const auto sensor = context.make<TimeSensor>();
  sensor->startTime.setValue(0);
  EXPECT_TRUE(sensor->isActive.getValue());
}

TEST_F(TimeSensorRules, StopsWhenDisabledAndGoesOnWhenEnabled) {
  const auto sensor = make(1, 4);
  context.tick(2);
  sensor->enabled.setValue(false);
  EXPECT_FALSE(sensor->isActive.getValue());
  context.tick(3);
  EXPECT_DOUBLE_EQ(sensor->time.getValue(), 2);
  sensor->enabled.setValue(true);
  EXPECT_TRUE(sensor->isActive.getValue());
  EXPECT_FLOAT_EQ(sensor->fraction_changed.getValue(), 0.5f);
}

TEST_F(TimeSensorRules, PauseHoldsAndResumeGoesOnWhereItWas) {
  const auto sensor = make(1, 4);
  context.tick(1);
  sensor->pauseTime.setValue(2);
  context.tick(2.5);
  EXPECT_TRUE(sensor->isPaused.getValue());
  EXPECT_TRUE(sensor->isActive.getValue());
  Recorder<SFTime> sent(sensor->time);
  context.tick(10);
  EXPECT_TRUE(sent.values.empty());
  EXPECT_FLOAT_EQ(sensor->fraction_changed.getValue(), 0.25f);
  EXPECT_DOUBLE_EQ(sensor->elapsedTime.getValue(), 1);
  sensor->resumeTime.setValue(20);
  context.tick(21);
  EXPECT_FALSE(sensor->isPaused.getValue());
  EXPECT_FLOAT_EQ(sensor->fraction_changed.getValue(), 0.5f);
  EXPECT_DOUBLE_EQ(sensor->elapsedTime.getValue(), 2);
  EXPECT_DOUBLE_EQ(sensor->time.getValue(), 21);
  context.tick(30);
  EXPECT_FALSE(sensor->isActive.getValue());
  EXPECT_EQ(sensor->fraction_changed.getValue(), 1.0f);
  EXPECT_DOUBLE_EQ(sensor->elapsedTime.getValue(), 4);
}

TEST_F(TimeSensorRules, PausesAndResumesByEventsOfNowRepeatedly) {
  const auto sensor = make(1, 100);
  context.tick(1);
  Time now = 1;
  for (int i = 0; i < 50; ++i) {
    context.tick(now += 0.25);
    sensor->pauseTime.setValue(now);
    context.tick(now += 1.75);
    sensor->resumeTime.setValue(now);
  }
  EXPECT_NEAR(sensor->elapsedTime.getValue(), 50 * 0.25, 1e-9);
  EXPECT_NEAR(sensor->fraction_changed.getValue(), 0.125, 1e-6);
}

TEST_F(TimeSensorRules, ReportsWhenItPausedAndResumed) {
  const auto sensor = make(5, 100);
  sensor->pauseTime.setValue(2);
  context.tick(6);
  EXPECT_TRUE(sensor->isPaused.getValue());
  EXPECT_DOUBLE_EQ(sensor->pauseTime.getValue(), 5) << "it could not pause before it ran";
}

TEST_F(TimeSensorRules, StopsWhilePaused) {
  const auto sensor = make(1, 100);
  context.tick(1);
  sensor->pauseTime.setValue(1);
  sensor->stopTime.setValue(3);
  context.tick(4);
  EXPECT_FALSE(sensor->isActive.getValue());
  EXPECT_FALSE(sensor->isPaused.getValue());
}

TEST_F(TimeSensorRules, GivesTheSameOutputsWhateverTheSteps) {
  for (const int steps : {1, 3, 64, 1000}) {
    TestContext own;
    const auto sensor = own.make<TimeSensor>([](TimeSensor& s) {
      s.startTime.setValue(0.5);
      s.loop.setValue(true);
      s.cycleInterval.setValue(0.7);
    });
    for (int i = 0; i <= steps; ++i) own.tick(10.0 * i / steps);
    EXPECT_NEAR(sensor->fraction_changed.getValue(), 9.5 / 0.7 - 13, 1e-5) << steps;
    EXPECT_NEAR(sensor->cycleTime.getValue(), 0.5 + 13 * 0.7, 1e-9) << steps;
    EXPECT_NEAR(sensor->elapsedTime.getValue(), 9.5, 1e-9) << steps;
  }
}

TEST_F(TimeSensorRules, NeverRunsWithoutACycle) {
  const auto sensor = make(1, 0, true);
  context.tick(2);
  EXPECT_FALSE(sensor->isActive.getValue());
}

}  // namespace
}  // namespace pleura
