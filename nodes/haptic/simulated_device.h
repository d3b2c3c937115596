#pragma once

#include <pleura/nodes/haptic/haptics_device_node.h>

namespace pleura {

/// A stylus that is not there: a mass in a hand that follows a path, as unstable where it is pushed too far
/// as a real one.
class SimulatedDevice : public HapticsDeviceNode {
 public:
  SFString model;
  MFString url;
  MFFloat key;
  MFVec3f keyValue;
  SFFloat handStiffness;
  SFFloat handDamping;
  SFFloat mass;
  SFFloat damping;
  SFFloat friction;
  SFFloat encoderStep;

  std::vector<std::string> drivers() const override { return {"simulated"}; }
  haptics::DeviceSettings settings() override;
  std::string file() override;

  static void declare(NodeType& type);

 protected:
  /// Tells what settings() would refuse, before anybody opens the device.
  void onInitialize() override;
};

}  // namespace pleura
