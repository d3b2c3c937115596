#include <gtest/gtest.h>

#include <pleura/haptics/recorded/recorded_device.h>
#include <pleura/haptics/recorded/recording_device.h>
#include <pleura/haptics/recorded/recording_format.h>
#include <pleura/tests/haptics/recorded/session.h>
#include <pleura/tests/x3d/temporary_folder.h>

namespace pleura::haptics {
namespace {

/// Half a second of the floor at 200 N/m.
Recording recordedFloor() {
  const TemporaryFolder folder;
  RecordingDevice device(dippingStylus(), folder.path() / "file");
  device.open();
  renderFloor(device, 200, 500, [](double, const DeviceState&) {});
  device.flush();
  return readRecording(folder.path() / "file");
}

TEST(RecordedDevice, ASessionPlayedBackIsTheSameBitForBit) {
  const auto recording = recordedFloor();
  for (const auto pace : {PlaybackPace::time, PlaybackPace::ticks}) {
    RecordedDevice device(recording, pace);
    device.open();
    std::size_t ticks = 0;
    renderFloor(device, 200, 500, [&](double time, const DeviceState& state) {
      const auto& recorded = recording.ticks[ticks++];
      EXPECT_EQ(toWords(RecordedTick{time, state, {}}),
                toWords(RecordedTick{recorded.time, recorded.state, {}}));
    });
    EXPECT_EQ(ticks, 500u);
    EXPECT_TRUE(device.hasEnded());
    EXPECT_FALSE(device.firstDifference());
  }
}

TEST(RecordedDevice, TheFirstForceThatDiffersIsTold) {
  const auto recording = recordedFloor();
  std::size_t contact = 0;
  while (recording.ticks[contact].force.force.y() == 0) ++contact;
  RecordedDevice device(recording);
  device.open();
  renderFloor(device, 200 * (1 + 1e-15), 500, [](double, const DeviceState&) {});
  ASSERT_TRUE(device.firstDifference());
  const auto& difference = *device.firstDifference();
  EXPECT_GE(difference.tick, contact);
  EXPECT_LE(difference.tick, contact + 20);
  EXPECT_EQ(difference.time, static_cast<int>(difference.tick) * 0.001);
  EXPECT_NE(difference.given.force.y(), difference.recorded.force.y());
  EXPECT_EQ(difference.recorded.force, recording.ticks[difference.tick].force.force);
}

TEST(RecordedDevice, ATorqueCountsToo) {
  auto recording = recordedFloor();
  recording.ticks[7].force.torque.x() = -0.0;
  RecordedDevice device(recording);
  device.open();
  renderFloor(device, 200, 500, [](double, const DeviceState&) {});
  ASSERT_TRUE(device.firstDifference());
  EXPECT_EQ(device.firstDifference()->tick, 7u);
}

TEST(RecordedDevice, ByTimeALoopOfAnotherRateAndStartFindsTheTickOfThen) {
  const auto recording = recordedFloor();
  RecordedDevice device(recording);
  device.open();
  DeviceState state;
  device.read(100, state);
  EXPECT_EQ(state.position, recording.ticks[0].state.position);
  device.read(100.2505, state);
  EXPECT_EQ(state.position, recording.ticks[250].state.position);
  device.read(100.2509, state);
  EXPECT_EQ(state.position, recording.ticks[250].state.position);
  EXPECT_FALSE(device.hasEnded());
  device.read(999, state);
  EXPECT_EQ(state.position, recording.ticks[499].state.position);
  EXPECT_TRUE(device.hasEnded());
}

TEST(RecordedDevice, OpenedAgainItBeginsAgain) {
  RecordedDevice device(recordedFloor(), PlaybackPace::ticks);
  DeviceState first, again;
  EXPECT_FALSE(device.read(0, first));
  EXPECT_FALSE(device.write({}));
  device.open();
  device.read(0, first);
  for (int i = 0; i < 100; ++i) device.read(1, again);
  device.write({.force = {9, 9, 9}});
  EXPECT_NE(again.position, first.position);
  EXPECT_TRUE(device.firstDifference());
  device.close();
  EXPECT_FALSE(device.read(2, again));
  device.open();
  device.read(3, again);
  EXPECT_EQ(again.position, first.position);
  EXPECT_FALSE(device.firstDifference());
}

TEST(RecordedDevice, NothingToPlayIsRefused) { EXPECT_THROW(RecordedDevice(Recording{}), RecordingError); }

}  // namespace
}  // namespace pleura::haptics
