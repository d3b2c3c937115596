#pragma once

#include <algorithm>
#include <vector>

#include <pleura/fields/field.h>

namespace pleura {

/// A field that remembers who has sent events since it was last evaluated or set. update() reads
/// getCausingEvents(), in the order of arrival, each sender once with its newest stamp.
template <class Base>
class EventCollectingField : public Base {
 public:
  EventCollectingField() { this->observesEvents(); }

 protected:
  const std::vector<Field::Event>& getCausingEvents() const { return events_; }
  bool hasCausedEvent(const Field& field) const {
    return std::any_of(events_.begin(), events_.end(), [&](const auto& e) { return e.sender == &field; });
  }

  void observe(Field::Event arrived) override {
    const auto known = std::find_if(events_.begin(), events_.end(),
                                    [&](const auto& e) { return e.sender == arrived.sender; });
    if (known != events_.end()) {
      known->stamp = arrived.stamp;
    } else {
      events_.push_back(arrived);
    }
  }

  void forgetEvents(const Field* sender, std::uint64_t stamp) override {
    std::erase_if(events_, [&](const auto& e) {
      return e.stamp <= stamp && (sender == nullptr || e.sender == sender);
    });
  }

 private:
  std::vector<Field::Event> events_;
};

}  // namespace pleura
