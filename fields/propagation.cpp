#include <algorithm>
#include <exception>
#include <utility>

#include <pleura/fields/counters.h>
#include <pleura/fields/errors.h>
#include <pleura/fields/propagation.h>

namespace pleura {

namespace {

/// How often in a row AutoUpdate fields may set what others of them hear of.
constexpr std::size_t kMostRounds = 100'000;

}  // namespace

/// The path from the origin to where the walk stands, and the fields to call back after it: one a thread,
/// reused.
struct Propagation::Walk {
  std::vector<Step> path;
  std::vector<Field*> observers;
  bool calling = false;

  static Walk& ofThread() {
    thread_local Walk walk;
    return walk;
  }
};

void Propagation::start(Field& origin) {
  const std::uint64_t stamp = nextStamp();
  origin.event.stamp = stamp;
  if (origin.settled_) return;
  walk({&origin, origin.routes_out.begin(), origin.routes_out.end(), true}, stamp);
  callObservers();
}

void Propagation::start(Field& origin, Field* target) {
  const std::uint64_t stamp = nextStamp();
  origin.event.stamp = stamp;
  walk({&origin, &target, &target + 1, false}, stamp);
  callObservers();
}

bool Propagation::isPassedOver(Field& field, std::uint64_t stamp) {
  const Field* above = field.event.sender;
  while (above != nullptr && above->settled_ && above->event.stamp < stamp) above = above->event.sender;
  if (above == nullptr || !above->settled_) return false;
  for (Field* below = &field; below != above; below = below->event.sender) below->event.stamp = stamp;
  return true;
}

void Propagation::tellObserver(Field& from, Field& to, std::uint64_t stamp) {
  to.observe({&from, stamp});
  if (to.queued_) return;
  to.queued_ = true;
  Walk::ofThread().observers.push_back(&to);
}

/// Marks `to` as out of date by `from`, if the event is news to it.
bool Propagation::arrive(Field& from, Field& to, std::uint64_t stamp) {
  if (to.observes_) tellObserver(from, to, stamp);
  if (to.event.stamp >= stamp) return false;
  if (to.event.sender != nullptr && to.event.sender->settled_) {
    if (isPassedOver(to, stamp)) return false;
    Field::unsettle(to.event.sender);
  }
  to.event = {&from, stamp};
  return true;
}

/// A field is settled as soon as only its last target is left to walk, so that a chain needs no path; should
/// that turn out wrong, whoever finds out unsettles what is above.
void Propagation::walk(Step step, std::uint64_t stamp) {
  auto& path = Walk::ofThread().path;
  const std::size_t base = path.size();
  std::uint64_t accepted = 0;
  while (true) {
    while (step.next != step.last) {
      Field& to = **step.next++;
      const bool isNews = arrive(*step.field, to, stamp);
      // An observing field has to hear every event, and one reached by two ways has to hear each of them.
      if (!isNews || to.observes_) step.settled = false;
      if (!isNews) continue;
      ++accepted;
      if (to.settled_) continue;
      if (to.routes_out.empty()) {
        to.settled_ = true;
        continue;
      }
      if (step.next == step.last) {
        settle(*step.field, step.settled);
      } else {
        path.push_back(step);
      }
      step = {&to, to.routes_out.begin(), to.routes_out.end(), true};
    }
    settle(*step.field, step.settled);
    if (path.size() == base) break;
    step = path.back();
    path.pop_back();
    if (!step.next[-1]->settled_) step.settled = false;
  }
  fieldCounters().events += accepted;
}

void Propagation::settle(Field& field, bool settled) {
  field.settled_ = settled;
  if (!settled) Field::unsettle(field.event.sender);
}

/// Each is called, though one before it throws; the first exception is thrown on. What an observer sets may
/// queue others: a round each.
void Propagation::callObservers() {
  Walk& walk = Walk::ofThread();
  if (walk.calling || walk.observers.empty()) return;
  walk.calling = true;
  std::exception_ptr failure;
  std::size_t roundEnd = walk.observers.size();
  for (std::size_t i = 0, rounds = 1; i < walk.observers.size(); ++i) {
    if (i == roundEnd) {
      roundEnd = walk.observers.size();
      ++rounds;
    }
    Field* field = std::exchange(walk.observers[i], nullptr);
    if (field == nullptr) continue;
    field->queued_ = false;
    try {
      if (rounds > kMostRounds)
        throw FieldError(field->getFullName() + " causes itself to change without end");
      field->afterEvents();
    } catch (...) {
      if (failure == nullptr) failure = std::current_exception();
    }
  }
  walk.observers.clear();
  walk.calling = false;
  if (failure != nullptr) std::rethrow_exception(failure);
}

void Propagation::forget(const Field* field) {
  auto& observers = Walk::ofThread().observers;
  std::replace(observers.begin(), observers.end(), const_cast<Field*>(field), static_cast<Field*>(nullptr));
}

}  // namespace pleura
