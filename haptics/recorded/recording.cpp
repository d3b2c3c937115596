#include <fstream>

#include <fmt/format.h>

#include <pleura/haptics/recorded/recording_format.h>
#include <pleura/haptics/safety/finite.h>

namespace pleura::haptics {

namespace {

constexpr std::uintmax_t kMostTicks = 10'000'000;

}  // namespace

Recording readRecording(const std::filesystem::path& file) {
  const auto refuse = [&](const std::string& why) -> RecordingError {
    return RecordingError(file.string() + ": " + why);
  };
  std::error_code error;
  if (!std::filesystem::is_regular_file(file, error)) throw refuse("there is no such recording");
  const auto size = std::filesystem::file_size(file, error);
  std::ifstream in(file, std::ios::binary);
  const auto read = [&](auto& words) {
    in.read(reinterpret_cast<char*>(words.data()), sizeof(words));
    return static_cast<std::size_t>(in.gcount()) == sizeof(words);
  };

  HeaderWords header{};
  if (!read(header) || header[0] != kRecordingMagic)
    throw refuse("byte 0: expected the header of a recording");
  if (header[1] != kRecordingVersion)
    throw refuse(fmt::format("byte 8: expected version {}, found {}", kRecordingVersion, header[1]));
  if (checksum(header) != header.back()) throw refuse("byte 0: the header is damaged");
  Recording recording{.capabilities = toCapabilities(header), .ticks = {}};
  try {
    recording.capabilities.check();
  } catch (const DeviceError& fault) {
    throw refuse(fmt::format("byte 0: {}", fault.what()));
  }

  const auto body = error ? 0 : size - sizeof(header);
  const auto ticks = body / sizeof(TickWords);
  if (ticks > kMostTicks) throw refuse(fmt::format("expected at most {} ticks, found {}", kMostTicks, ticks));
  recording.ticks.reserve(ticks);
  for (std::uintmax_t i = 0; i < ticks; ++i) {
    const auto damaged = [&](std::string_view why) {
      return refuse(
          fmt::format("byte {}: tick {} of {} {}", sizeof(header) + i * sizeof(TickWords), i, ticks, why));
    };
    TickWords words{};
    if (!read(words)) throw damaged("can't be read");
    if (checksum(words) != words.back()) throw damaged("is damaged");
    const auto tick = toTick(words);
    if (!std::isfinite(tick.time) || !isFinite(tick.state)) throw damaged("is not finite");
    if (i > 0 && tick.time < recording.ticks.back().time) throw damaged("goes back in time");
    recording.ticks.push_back(tick);
  }
  if (const auto rest = body % sizeof(TickWords); rest != 0)
    throw refuse(
        fmt::format("byte {}: expected a tick of {} bytes, found {}: the file is cut off after {} ticks",
                    size - rest, sizeof(TickWords), rest, ticks));
  return recording;
}

}  // namespace pleura::haptics
