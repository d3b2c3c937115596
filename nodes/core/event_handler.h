#pragma once

#include <functional>

#include <pleura/fields/auto_update.h>
#include <pleura/fields/event_collecting_field.h>
#include <pleura/nodes/core/node.h>

namespace pleura {

/// How a node acts on events: after each propagation that reached a field it hears(), that field is brought
/// up to date and the function called, once for all of them. Not a field of the node: scenes don't see it.
class EventHandler : public AutoUpdate<EventCollectingField<SFBool>> {
 public:
  explicit EventHandler(std::function<void()> handle) : handle_(std::move(handle)) {}

  /// Listens to fields of `node`, or to others that can be read.
  template <class... Fields>
  void hears(const Node& node, Fields&... fields) {
    (fields.routeNoEvent(*this, node.id), ...);
  }
  /// Whether the field is among those that the function is called for; only inside of it.
  bool heard(const Field& field) const { return hasCausedEvent(field); }

 protected:
  bool acceptsInput(const Field&, std::size_t, std::string&) const override { return true; }
  void update() override {
    for (Field* input : routes_in) input->upToDate();
    handle_();
  }

 private:
  std::function<void()> handle_;
};

}  // namespace pleura
