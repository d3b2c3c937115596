#include <algorithm>
#include <cassert>

#include <pleura/haptics/recorded/recording_format.h>
#include <pleura/haptics/recorded/recording_writer.h>

namespace pleura::haptics {

RecordingWriter::RecordingWriter(const std::filesystem::path& file, const DeviceCapabilities& capabilities,
                                 std::size_t capacity)
    : file_(file), out_(file, std::ios::binary), ring_(capacity) {
  assert(capacity >= 1);
  const auto words = toWords(capabilities);
  if (!out_.write(reinterpret_cast<const char*>(words.data()), sizeof(words)))
    throw RecordingError(file.string() + ": can't be written");
}

RecordingWriter::~RecordingWriter() {
  try {
    flush();
  } catch (const RecordingError&) {
    // Nobody is left to be told: who wants to know flushes before.
  }
}

bool RecordingWriter::add(const RecordedTick& tick) noexcept {
  const auto added = added_.load(std::memory_order_relaxed);
  if (added - flushed_.load(std::memory_order_acquire) == ring_.size()) isCutOff_ = true;
  if (isCutOff_) return false;
  ring_[added % ring_.size()] = tick;
  added_.store(added + 1, std::memory_order_release);
  return true;
}

void RecordingWriter::flush() {
  const auto added = added_.load(std::memory_order_acquire);
  for (auto i = flushed_.load(std::memory_order_relaxed); i < added; ++i) {
    const auto words = toWords(ring_[i % ring_.size()]);
    out_.write(reinterpret_cast<const char*>(words.data()), sizeof(words));
    flushed_.store(i + 1, std::memory_order_release);
  }
  if (!out_.flush()) throw RecordingError(file_.string() + ": can't be written: is the disk full?");
}

}  // namespace pleura::haptics
