#pragma once

#include <pleura/haptics/device/device_registry.h>
#include <pleura/nodes/core/typed_node_field.h>
#include <pleura/nodes/standard/core/x3d_child_node.h>

namespace pleura {

/// A haptic device as a scene sees it (H3DHapticsDevice): how it stands in the scene, and what it tells. The
/// outputs are set once a tick, from the last report of the haptic loop. What is device... is in the device's
/// own frame, what is tracker... in the scene's.
class HapticsDeviceNode : public Node {
 public:
  // How it stands in the scene.
  SFMatrix4f positionCalibration;
  SFRotation orientationCalibration;
  SFFloat workspaceScale;
  SFBool followViewpoint;
  SFFloat proxyRadius;
  SFFloat proxyWeighting;
  SFNode stylus;
  // What it may do.
  SFFloat forceLimit;
  SFFloat torqueLimit;
  SFBool deadmansSwitch;
  SFInt32 desiredHapticsRate;

  // What it tells.
  SFVec3f devicePosition;
  SFRotation deviceOrientation;
  SFVec3f deviceVelocity;
  SFVec3f trackerPosition;
  SFRotation trackerOrientation;
  SFVec3f trackerVelocity;
  SFVec3f proxyPosition;
  SFVec3f weightedProxyPosition;
  SFVec3f tipPosition;
  SFBool mainButton;
  SFBool secondaryButton;
  SFInt32 buttons;
  SFVec3f force;
  SFVec3f torque;
  SFRotation forceRotation;
  SFVec3f forceScale;
  SFFloat depth;
  SFString touched;
  MFString label;
  SFInt32 inputDOF;
  SFInt32 outputDOF;
  SFInt32 hapticsRate;
  SFTime hapticsLoopTime;
  SFBool isConnected;

  /// The drivers that may serve it, the first that opens does.
  virtual std::vector<std::string> drivers() const = 0;
  /// What they are asked for, but for the file. Throws haptics::DeviceError on figures that make no sense.
  virtual haptics::DeviceSettings settings() { return {}; }
  /// Where the file is that the driver needs, in the scene's folder; empty: none.
  virtual std::string file() { return {}; }

  static void declare(NodeType& type);
};

}  // namespace pleura
