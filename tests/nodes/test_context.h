#pragma once

#include <memory>
#include <string>
#include <vector>

#include <pleura/nodes/core/node_type.h>
#include <pleura/nodes/core/scene_context.h>

namespace pleura {

/// A scene without a file: keeps what nodes warn of, and passes time and keys on.
class TestContext : public SceneContext {
 public:
  std::vector<std::string> warnings;

  void warn(const Node& node, const std::string& message) override {
    warnings.push_back(node.describe() + ": " + message);
  }
  void tick(Time now) { time.setValue(now); }
  void key(const KeyEvent& event) {
    for (auto* listener : keyListeners_) listener->onKey(event);
  }

  /// A node of class T in this scene, initialized once `set` has given its fields their values.
  template <class T, class Set>
  std::shared_ptr<T> make(Set set) {
    auto node = create<T>();
    set(*node);
    node->initialize(*this);
    return node;
  }
  template <class T>
  std::shared_ptr<T> make() {
    return make<T>([](T&) {});
  }
};

/// Counts the events that reach it, and keeps the values.
template <class Base>
class Recorder : public Base {
 public:
  explicit Recorder(Field& from) {
    this->observesEvents();
    from.routeNoEvent(*this);
  }
  std::vector<typename Base::value_type> values;

 protected:
  void afterEvents() override {
    this->upToDate();
    values.push_back(this->value);
  }
};

}  // namespace pleura
