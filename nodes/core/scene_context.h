#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include <pleura/fields/field_types.h>
#include <pleura/nodes/core/bindable_stack.h>

namespace pleura {

/// A key going down or up, as X3D's KeySensor tells them apart.
struct KeyEvent {
  enum class Kind { character, action, shift, control, alt };
  Kind kind = Kind::character;
  bool pressed = true;
  std::string character;  // Kind::character: one character, UTF-8
  int action = 0;         // Kind::action: X3D's number of the action key (ISO/IEC 19775-1, table 21.3)
};

class KeyListener {
 public:
  virtual void onKey(const KeyEvent& event) = 0;

 protected:
  ~KeyListener() = default;
};

/// What a node may ask of the scene it lives in. It outlives its nodes and belongs to their thread.
class SceneContext {
 public:
  SFTime time;  // the scene's time [s]: set once a tick, first of all

  virtual ~SceneContext() = default;

  /// Listeners hear each key in the order they were added.
  void addKeyListener(KeyListener* listener) { keyListeners_.push_back(listener); }
  void removeKeyListener(KeyListener* listener) { std::erase(keyListeners_, listener); }

  /// The bound nodes of a kind: "Viewpoint", "NavigationInfo", "Background" or "Fog". A stack stays where it
  /// is.
  BindableStack& bindables(std::string_view kind) {
    const auto found = bindables_.find(kind);
    return found != bindables_.end() ? found->second : bindables_[std::string(kind)];
  }

  /// Tells the scene's author something about a node.
  virtual void warn(const Node& node, const std::string& message) = 0;

 protected:
  std::vector<KeyListener*> keyListeners_;

 private:
  std::map<std::string, BindableStack, std::less<>> bindables_;
};

}  // namespace pleura
