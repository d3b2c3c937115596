#pragma once

#include <atomic>
#include <cstdint>

#include <pleura/fields/field.h>

namespace pleura {

/// Carries events along the routes: depth first, in the order of the routes, a field accepting an event only
/// when it is newer than the last it has seen. So a diamond is marked once and a cycle ends. A field whose
/// whole downstream is out of date already (`settled_`) is not walked again: setting what nobody has read
/// since costs nothing per edge. No recursion: the length of a chain is bounded by memory only.
class Propagation {
 public:
  /// A change of `origin` made now, told to all it routes to.
  static void start(Field& origin);
  /// The same told to one of its targets only.
  static void start(Field& origin, Field* target);
  /// `field` is being destroyed and must not be called back.
  static void forget(const Field* field);
  /// Of the last change made anywhere.
  static std::uint64_t lastStamp() { return stamp_.load(std::memory_order_relaxed); }
  /// Whether an event of this stamp or a later one has passed over `field`, with all else that is below a
  /// settled field. What is found is noted in the stamps, so that no way up is gone twice.
  static bool isPassedOver(Field& field, std::uint64_t stamp);

 private:
  struct Step {
    Field* field;
    Field* const* next;
    Field* const* last;
    bool settled;  // every target so far is out of date by way of `field`, with all that follows it
  };
  struct Walk;
  static std::uint64_t nextStamp() { return stamp_.fetch_add(1, std::memory_order_relaxed) + 1; }
  static void walk(Step step, std::uint64_t stamp);
  static void tellObserver(Field& from, Field& to, std::uint64_t stamp);
  static bool arrive(Field& from, Field& to, std::uint64_t stamp);
  static void settle(Field& field, bool settled);
  static void callObservers();

  static inline std::atomic<std::uint64_t> stamp_{0};
};

}  // namespace pleura
