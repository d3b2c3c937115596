#include <algorithm>
#include <bit>
#include <cstring>
#include <type_traits>

#include <pleura/haptics/recorded/recording_format.h>

namespace pleura::haptics {

namespace {

static_assert(std::endian::native == std::endian::little, "words are written as they lie in memory");

constexpr std::size_t kModelLetters = 64;

/// Visits the figures of capabilities, and the values of a tick, in the order of the file.
template <class Capabilities, class Visit>
void visitFigures(Capabilities& of, Visit&& visit) {
  visit(of.maxForce), visit(of.maxTorque), visit(of.maxStiffness), visit(of.maxDamping);
  visit(of.workspaceRadius), visit(of.mass), visit(of.damping), visit(of.friction), visit(of.encoderStep);
  visit(of.inputDof), visit(of.outputDof), visit(of.buttons);
}

template <class Tick, class Visit>
void visitValues(Tick& of, Visit&& visit) {
  visit(of.time);
  for (int i = 0; i < 3; ++i) visit(of.state.position[i]);
  for (int i = 0; i < 4; ++i) visit(of.state.orientation.coeffs()[i]);
  for (int i = 0; i < 3; ++i) visit(of.state.velocity[i]);
  visit(of.state.buttons);
  for (int i = 0; i < 3; ++i) visit(of.force.force[i]);
  for (int i = 0; i < 3; ++i) visit(of.force.torque[i]);
}

template <class Value>
std::uint64_t toWord(const Value& value) {
  if constexpr (std::is_floating_point_v<Value>)
    return std::bit_cast<std::uint64_t>(value);
  else
    return static_cast<std::uint32_t>(value);
}

template <class Value>
void fromWord(std::uint64_t word, Value& value) {
  if constexpr (std::is_floating_point_v<Value>)
    value = std::bit_cast<Value>(word);
  else
    value = static_cast<Value>(static_cast<std::uint32_t>(word));
}

}  // namespace

HeaderWords toWords(const DeviceCapabilities& capabilities) {
  HeaderWords words{kRecordingMagic, kRecordingVersion};
  std::size_t next = 2;
  visitFigures(capabilities, [&](const auto& figure) { words[next++] = toWord(figure); });
  std::memcpy(&words[next], capabilities.model.data(), std::min(kModelLetters, capabilities.model.size()));
  words.back() = checksum(words);
  return words;
}

DeviceCapabilities toCapabilities(const HeaderWords& words) {
  DeviceCapabilities capabilities;
  std::size_t next = 2;
  visitFigures(capabilities, [&](auto& figure) { fromWord(words[next++], figure); });
  std::array<char, kModelLetters> model{};
  std::memcpy(model.data(), &words[next], model.size());
  capabilities.model.assign(model.begin(), std::find(model.begin(), model.end(), '\0'));
  return capabilities;
}

TickWords toWords(const RecordedTick& tick) {
  TickWords words{};
  std::size_t next = 0;
  visitValues(tick, [&](const auto& value) { words[next++] = toWord(value); });
  words.back() = checksum(words);
  return words;
}

RecordedTick toTick(const TickWords& words) {
  RecordedTick tick;
  std::size_t next = 0;
  visitValues(tick, [&](auto& value) { fromWord(words[next++], value); });
  return tick;
}

}  // namespace pleura::haptics
