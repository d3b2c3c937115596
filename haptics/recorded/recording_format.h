#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include <pleura/haptics/recorded/recording.h>

namespace pleura::haptics {

/// A recording's file: a header, then ticks, each an array of little-endian 64-bit words of which the last is
/// a checksum of the others.
///   header: "PleuraHR", version 1, the figures of DeviceCapabilities in order, 64 letters of its model
///   tick:   time, position, orientation x y z w, velocity, buttons, force, torque
using HeaderWords = std::array<std::uint64_t, 23>;
using TickWords = std::array<std::uint64_t, 19>;

constexpr std::uint64_t kRecordingMagic = 0x5248617275656c50;  // "PleuraHR"
constexpr std::uint64_t kRecordingVersion = 1;

HeaderWords toWords(const DeviceCapabilities& capabilities);
TickWords toWords(const RecordedTick& tick);
DeviceCapabilities toCapabilities(const HeaderWords& words);
RecordedTick toTick(const TickWords& words);

/// FNV-1a over the bytes of all words but the last, which is where it belongs.
template <std::size_t N>
std::uint64_t checksum(const std::array<std::uint64_t, N>& words) {
  std::uint64_t sum = 0xcbf29ce484222325;
  for (std::size_t i = 0; i + 1 < N; ++i)
    for (int shift = 0; shift < 64; shift += 8) sum = (sum ^ (words[i] >> shift & 0xff)) * 0x100000001b3;
  return sum;
}

}  // namespace pleura::haptics
