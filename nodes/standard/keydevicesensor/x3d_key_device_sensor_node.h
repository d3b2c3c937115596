#pragma once

#include <pleura/nodes/core/event_handler.h>
#include <pleura/nodes/core/scene_context.h>
#include <pleura/nodes/standard/core/x3d_sensor_node.h>

namespace pleura {

/// A node that hears keys.
class X3DKeyDeviceSensorNode : public X3DSensorNode, private KeyListener {
 public:
  ~X3DKeyDeviceSensorNode() override;

 protected:
  void onInitialize() override;
  /// Called for every key while the node is enabled.
  virtual void hear(const KeyEvent& event) = 0;

 private:
  void onKey(const KeyEvent& event) override;
  EventHandler onEnabled_{[this] {
    if (!enabled.getValue()) isActive.setValueIfChanged(false, id);
  }};
};

}  // namespace pleura
