#pragma once

#include <algorithm>
#include <vector>

#include <pleura/fields/field.h>

namespace pleura {

/// A field that remembers who has sent events since it was last evaluated. update() reads getCausingEvents(),
/// in the order of arrival, each sender once with its newest stamp.
template <class Base>
class EventCollectingField : public Base {
 public:
  EventCollectingField() { this->observesEvents(); }

 protected:
  const std::vector<Field::Event>& getCausingEvents() const { return events_; }
  bool hasCausedEvent(const Field& field) const {
    return std::any_of(events_.begin(), events_.end(), [&](const auto& e) { return e.sender == &field; });
  }

  void observe(Field::Event event) override {
    const auto known =
        std::find_if(events_.begin(), events_.end(), [&](const auto& e) { return e.sender == event.sender; });
    if (known != events_.end()) {
      known->stamp = event.stamp;
    } else {
      events_.push_back(event);
    }
  }

  void afterUpdate() override { events_.clear(); }

 private:
  std::vector<Field::Event> events_;
};

}  // namespace pleura
