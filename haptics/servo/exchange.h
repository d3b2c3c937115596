#pragma once

#include <array>
#include <atomic>
#include <cstdint>

namespace pleura::haptics {

/// Hands the latest T from one thread to another, neither ever waiting: the writer fills back() and publishes
/// it, the reader takes the latest and keeps the last kKept that it took. A triple buffer for kKept = 1.
/// Slots change hands and are never copied, so what they own is made and freed by the writer alone.
template <class T, int kKept>
class Exchange {
 public:
  // The writer's.
  T& back() { return slots_[back_]; }
  /// back() is another slot after this, with what it was published with some time ago.
  void publish() { back_ = pending_.exchange(back_ | kFresh, std::memory_order_acq_rel) & kIndex; }

  // The reader's.
  /// Takes the latest; false when nothing was published since the last take.
  bool take() {
    if ((pending_.load(std::memory_order_relaxed) & kFresh) == 0) return false;
    const std::uint8_t oldest = kept_[kKept - 1];
    const std::uint8_t latest = pending_.exchange(oldest, std::memory_order_acq_rel) & kIndex;
    for (int k = kKept - 1; k > 0; --k) kept_[k] = kept_[k - 1];
    kept_[0] = latest;
    return true;
  }
  /// What was taken `age` takes ago, 0 <= age < kKept; T() where there were not so many.
  const T& taken(int age = 0) const { return slots_[kept_[age]]; }
  T& taken(int age = 0) { return slots_[kept_[age]]; }

 private:
  static constexpr std::uint8_t kFresh = 0x80;
  static constexpr std::uint8_t kIndex = 0x7f;

  static constexpr std::array<std::uint8_t, kKept> firstKept() {
    std::array<std::uint8_t, kKept> all{};
    for (int k = 0; k < kKept; ++k) all[k] = static_cast<std::uint8_t>(k + 2);
    return all;
  }

  std::array<T, kKept + 2> slots_{};
  alignas(64) std::atomic<std::uint8_t> pending_ = 1;
  alignas(64) std::uint8_t back_ = 0;                               // the writer's
  alignas(64) std::array<std::uint8_t, kKept> kept_ = firstKept();  // the reader's, latest first
};

}  // namespace pleura::haptics
