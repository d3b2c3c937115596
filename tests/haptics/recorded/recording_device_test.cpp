#include <gtest/gtest.h>

#include <pleura/haptics/recorded/recording_device.h>
#include <pleura/haptics/recorded/recording_format.h>
#include <pleura/tests/haptics/recorded/session.h>
#include <pleura/tests/x3d/temporary_folder.h>

namespace pleura::haptics {
namespace {

TEST(RecordingDevice, RecordsWhatTheDeviceToldAndWasGiven) {
  const TemporaryFolder folder;
  std::vector<DeviceState> told;
  RecordingDevice device(dippingStylus(), folder.path() / "file");
  device.open();
  renderFloor(device, 200, 500, [&](double, const DeviceState& state) { told.push_back(state); });
  device.close();
  device.flush();

  const auto recording = readRecording(folder.path() / "file");
  EXPECT_EQ(recording.capabilities.model, "dipping");
  ASSERT_EQ(recording.ticks.size(), 500u);
  double mostForce = 0;
  for (std::size_t i = 0; i < told.size(); ++i) {
    const auto& tick = recording.ticks[i];
    EXPECT_EQ(toWords(tick), toWords(RecordedTick{static_cast<int>(i) * 0.001, told[i], tick.force}));
    EXPECT_EQ(tick.force.force.y(), 200 * std::max(0.0, -told[i].position.y()));
    mostForce = std::max(mostForce, tick.force.force.y());
  }
  EXPECT_GT(mostForce, 0.5);
}

TEST(RecordingDevice, ADeviceThatWasLostIsRecordedOnWhenItIsBack) {
  const TemporaryFolder folder;
  auto stylus = dippingStylus();
  auto& plug = *stylus;
  RecordingDevice device(std::move(stylus), folder.path() / "file");
  DeviceState state;
  const auto tick = [&](double time) { return device.read(time, state) && device.write({}); };
  device.open();
  EXPECT_TRUE(tick(0.000));
  plug.unplug();
  EXPECT_FALSE(tick(0.001));
  EXPECT_FALSE(device.write({}));
  plug.replug();
  device.open();
  EXPECT_TRUE(tick(0.002));
  device.flush();
  const auto recording = readRecording(folder.path() / "file");
  ASSERT_EQ(recording.ticks.size(), 2u);
  EXPECT_EQ(recording.ticks[1].time, 0.002);
}

TEST(RecordingDevice, ARecordingThatEndedEarlyIsTold) {
  const TemporaryFolder folder;
  RecordingDevice device(dippingStylus(), folder.path() / "file", 10);
  device.open();
  renderFloor(device, 200, 11, [](double, const DeviceState&) {});
  EXPECT_THROW(device.flush(), RecordingError);
}

TEST(RecordingDevice, WithoutAFileItStaysClosed) {
  const TemporaryFolder folder;
  RecordingDevice device(dippingStylus(), folder.path() / "missing" / "file");
  EXPECT_THROW(device.open(), RecordingError);
  DeviceState state;
  EXPECT_FALSE(device.read(0, state));
  EXPECT_NO_THROW(device.flush());
}

}  // namespace
}  // namespace pleura::haptics
