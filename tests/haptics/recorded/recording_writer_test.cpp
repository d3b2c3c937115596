#include <atomic>
#include <thread>

#include <gtest/gtest.h>

#include <pleura/haptics/device/device_presets.h>
#include <pleura/haptics/recorded/recording_writer.h>
#include <pleura/tests/x3d/temporary_folder.h>

namespace pleura::haptics {
namespace {

RecordedTick numbered(int number) { return {.time = static_cast<double>(number), .state = {}, .force = {}}; }

TEST(RecordingWriter, BuffersUpToItsCapacityThenEnds) {
  const TemporaryFolder folder;
  const auto file = folder.path() / "file";
  RecordingWriter writer(file, devicePreset("Touch"), 4);
  for (int i = 0; i < 4; ++i) EXPECT_TRUE(writer.add(numbered(i)));
  EXPECT_FALSE(writer.isCutOff());
  EXPECT_FALSE(writer.add(numbered(4)));
  EXPECT_TRUE(writer.isCutOff());
  writer.flush();
  EXPECT_FALSE(writer.add(numbered(5)));  // it would leave a gap
  writer.flush();
  EXPECT_EQ(readRecording(file).ticks.size(), 4u);
}

TEST(RecordingWriter, FlushedInTimeItGoesOn) {
  const TemporaryFolder folder;
  const auto file = folder.path() / "file";
  RecordingWriter writer(file, devicePreset("Touch"), 4);
  for (int i = 0; i < 100; ++i) {
    EXPECT_TRUE(writer.add(numbered(i)));
    if (i % 3 == 0) writer.flush();
  }
  writer.flush();
  const auto recording = readRecording(file);
  ASSERT_EQ(recording.ticks.size(), 100u);
  for (int i = 0; i < 100; ++i) EXPECT_EQ(recording.ticks[i].time, i);
}

TEST(RecordingWriter, TwoThreadsNeitherWaitNorLose) {
  const TemporaryFolder folder;
  const auto file = folder.path() / "file";
  constexpr int kTicks = 20'000;
  {
    RecordingWriter writer(file, devicePreset("Touch"), kTicks);
    std::atomic<bool> isDone = false;
    std::thread loop([&] {
      for (int i = 0; i < kTicks; ++i) writer.add(numbered(i));
      isDone = true;
    });
    while (!isDone) writer.flush();
    loop.join();
  }
  const auto recording = readRecording(file);
  ASSERT_EQ(recording.ticks.size(), kTicks);
  for (int i = 0; i < kTicks; ++i) ASSERT_EQ(recording.ticks[i].time, i);
}

TEST(RecordingWriter, AFileThatCanNotBeWrittenIsTold) {
  const TemporaryFolder folder;
  EXPECT_THROW(RecordingWriter(folder.path() / "missing" / "file", devicePreset("Touch")), RecordingError);
  EXPECT_THROW(RecordingWriter("/dev/full", devicePreset("Touch")).flush(), RecordingError);
}

}  // namespace
}  // namespace pleura::haptics
