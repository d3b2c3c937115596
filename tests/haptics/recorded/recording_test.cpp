#include <fstream>
#include <limits>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <pleura/haptics/recorded/recording_format.h>
#include <pleura/haptics/recorded/recording_writer.h>
#include <pleura/tests/x3d/temporary_folder.h>

namespace pleura::haptics {
namespace {

using ::testing::HasSubstr;

const DeviceCapabilities kRecordedModel{.model = "recorded",
                                        .maxForce = 1,
                                        .maxStiffness = 2,
                                        .maxDamping = 3,
                                        .workspaceRadius = 4,
                                        .mass = 5,
                                        .damping = 6,
                                        .friction = 7,
                                        .encoderStep = 8,
                                        .inputDof = 3,
                                        .outputDof = 0,
                                        .buttons = 11};

RecordedTick tickAt(double time) {
  RecordedTick tick{.time = time, .state = {}, .force = {}};
  tick.state.position = {0.1 + time, -0.0, std::numeric_limits<double>::denorm_min()};
  tick.state.orientation.coeffs() << 0.1, 0.2, 0.3, 0.9;
  tick.state.velocity = {1.0 / 3, -1e300, 1e-300};
  tick.state.buttons = 0x80000001;
  tick.force.force = {time, 2, 3};
  tick.force.torque = {4, 5, 6 + time};
  return tick;
}

std::string threeTicks(const TemporaryFolder& folder) {
  const auto file = folder.path() / "three";
  {
    RecordingWriter writer(file, kRecordedModel);
    for (const double time : {0.0, 0.1, 0.2}) writer.add(tickAt(time));
  }
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

std::string recordingFault(const std::filesystem::path& file) {
  try {
    readRecording(file);
  } catch (const RecordingError& error) {
    return error.what();
  }
  return "none";
}

TEST(Recording, ComesBackBitForBit) {
  const TemporaryFolder folder;
  const auto recording = readRecording(folder.write("copy", threeTicks(folder)));
  EXPECT_EQ(toWords(recording.capabilities), toWords(kRecordedModel));
  EXPECT_EQ(recording.capabilities.model, "recorded");
  EXPECT_EQ(recording.capabilities.encoderStep, 8);
  EXPECT_EQ(recording.capabilities.buttons, 11);
  ASSERT_EQ(recording.ticks.size(), 3u);
  for (int i = 0; i < 3; ++i) EXPECT_EQ(toWords(recording.ticks[i]), toWords(tickAt(0.1 * i)));
  EXPECT_TRUE(std::signbit(recording.ticks[0].state.position.y()));
  EXPECT_EQ(recording.ticks[2].state.buttons, 0x80000001);
  EXPECT_EQ(recording.ticks[2].force.torque.z(), 6.2);
}

TEST(Recording, ALongModelIsCut) {
  auto capabilities = kRecordedModel;
  capabilities.model = std::string(100, 'x');
  EXPECT_EQ(toCapabilities(toWords(capabilities)).model, std::string(64, 'x'));
}

TEST(Recording, CutOffAnywhereItIsRefusedOrShorter) {
  const TemporaryFolder folder;
  const std::string whole = threeTicks(folder);
  ASSERT_EQ(whole.size(), sizeof(HeaderWords) + 3 * sizeof(TickWords));
  for (std::size_t size = 0; size < whole.size(); ++size) {
    const auto file = folder.write("cut", std::string_view(whole).substr(0, size));
    const bool isBetweenTicks =
        size >= sizeof(HeaderWords) && (size - sizeof(HeaderWords)) % sizeof(TickWords) == 0;
    EXPECT_EQ(recordingFault(file) == "none", isBetweenTicks) << size;
  }
  EXPECT_THAT(
      recordingFault(folder.write("cut", whole.substr(0, whole.size() - 10))),
      HasSubstr("byte 488: expected a tick of 152 bytes, found 142: the file is cut off after 2 ticks"));
}

TEST(Recording, AnyDamagedByteIsFound) {
  const TemporaryFolder folder;
  const std::string whole = threeTicks(folder);
  for (std::size_t at = 0; at < whole.size(); ++at) {
    std::string damaged = whole;
    damaged[at] = static_cast<char>(damaged[at] ^ 1 << at % 8);
    EXPECT_NE(recordingFault(folder.write("damaged", damaged)), "none") << at;
  }
  std::string damaged = whole;
  ++damaged[sizeof(HeaderWords) + sizeof(TickWords) + 3];
  EXPECT_THAT(recordingFault(folder.write("damaged", damaged)),
              HasSubstr("damaged: byte 336: tick 1 of 3 is damaged"));
}

TEST(Recording, WhatIsNoRecordingIsRefused) {
  const TemporaryFolder folder;
  EXPECT_THAT(recordingFault(folder.path() / "missing"), HasSubstr("missing: there is no such recording"));
  EXPECT_THAT(recordingFault(folder.path()), HasSubstr("there is no such recording"));
  EXPECT_THAT(recordingFault("/dev/zero"), HasSubstr("there is no such recording"));
  EXPECT_THAT(recordingFault(folder.write("empty", "")),
              HasSubstr("byte 0: expected the header of a recording"));
  EXPECT_THAT(recordingFault(folder.write("other", std::string(1000, 'x'))),
              HasSubstr("expected the header"));
  const auto large = folder.write("large", threeTicks(folder));
  std::filesystem::resize_file(large, 1'000'000'000'000);  // a hole: it takes no room
  EXPECT_THAT(recordingFault(large), HasSubstr("expected at most 10000000 ticks, found"));
}

/// A file of one tick after a whole one, whatever it says.
std::string faultOfTick(const RecordedTick& tick) {
  const TemporaryFolder folder;
  {
    RecordingWriter writer(folder.path() / "file", kRecordedModel);
    writer.add(tickAt(1));
    writer.add(tick);
  }
  return recordingFault(folder.path() / "file");
}

TEST(Recording, StatesThatNoDeviceTellsAreRefused) {
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  auto tick = tickAt(2);
  EXPECT_EQ(faultOfTick(tick), "none");
  tick.state.position.x() = kNan;
  EXPECT_THAT(faultOfTick(tick), HasSubstr("byte 336: tick 1 of 2 is not finite"));
  tick = tickAt(2);
  tick.state.orientation.w() = kNan;
  EXPECT_THAT(faultOfTick(tick), HasSubstr("is not finite"));
  EXPECT_THAT(faultOfTick(tickAt(kNan)), HasSubstr("is not finite"));
  EXPECT_THAT(faultOfTick(tickAt(0.5)), HasSubstr("goes back in time"));
}

TEST(Recording, ImpossibleCapabilitiesAreRefused) {
  const TemporaryFolder folder;
  auto capabilities = kRecordedModel;
  capabilities.mass = 0;
  RecordingWriter(folder.path() / "file", capabilities).flush();
  EXPECT_THAT(recordingFault(folder.path() / "file"), HasSubstr("mass is 0"));
}

TEST(Recording, AnOtherVersionIsNamed) {
  const TemporaryFolder folder;
  std::string whole = threeTicks(folder);
  whole[8] = 2;
  EXPECT_THAT(recordingFault(folder.write("new", whole)), HasSubstr("byte 8: expected version 1, found 2"));
}

}  // namespace
}  // namespace pleura::haptics
