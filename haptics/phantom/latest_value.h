#pragma once

#include <array>
#include <atomic>

namespace pleura::haptics {

/// Hands the newest value from one thread to another, which neither ever wait: of three slots one is being
/// written, one read, and the third is what is newest between them.
template <class Value>
class LatestValue {
 public:
  /// The one writing thread.
  void put(const Value& value) noexcept {
    slots_[written_] = value;
    written_ = between_.exchange(written_ | kIsNew, std::memory_order_acq_rel) & kSlot;
  }

  /// The one reading thread. False, `value` untouched: nothing was put since the last take.
  bool take(Value& value) noexcept {
    if ((between_.load(std::memory_order_relaxed) & kIsNew) == 0) return false;
    read_ = between_.exchange(read_, std::memory_order_acq_rel) & kSlot;
    value = slots_[read_];
    return true;
  }

 private:
  static constexpr unsigned kSlot = 3, kIsNew = 4;

  std::array<Value, 3> slots_{};
  unsigned written_ = 0;
  unsigned read_ = 1;
  std::atomic<unsigned> between_ = 2;
};

}  // namespace pleura::haptics
