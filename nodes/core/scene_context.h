#pragma once

#include <map>
#include <string>
#include <string_view>
#include <utility>
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

/// What a way to deform an organ costs on this machine and how far it is from the reference, as `pleura
/// tradeoff` measured it.
struct DeformationFigure {
  std::string organ;                                        // DEF name
  std::string deformer;                                     // node type; empty: the contacts' smooth fill
  std::vector<std::pair<std::string, std::string>> fields;  // of the deformer, as text
  double error = 0;                                         // [m] RMS
  double cost = 0;                                          // [s] median
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

  /// A node of a type that the scene knows; null for another.
  virtual NodePtr make(std::string_view /*type*/) { return nullptr; }
  /// What was measured on this machine; none: nothing was.
  virtual std::vector<DeformationFigure> deformationFigures() { return {}; }

  /// Tells the scene's author something about a node.
  virtual void warn(const Node& node, const std::string& message) = 0;

 protected:
  std::vector<KeyListener*> keyListeners_;

 private:
  std::map<std::string, BindableStack, std::less<>> bindables_;
};

}  // namespace pleura
