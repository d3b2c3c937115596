#pragma once

#include <memory>
#include <vector>

#include <pleura/haptics/contact/proxy.h>
#include <pleura/haptics/servo/force_effect.h>

namespace pleura::haptics {

/// From a device's frame to the world: x_world = rotation (scale x_device) + translation.
struct Workspace {
  double scale = 1;  // metres of the scene that a metre of the device is
  Eigen::Isometry3d placement = Eigen::Isometry3d::Identity();
};

/// A shape that can be felt, as the scene last had it.
struct TouchFrameShape {
  std::uint32_t id = 0;  // the same in every frame
  std::shared_ptr<const TouchMesh> mesh;
  TouchMeshFrame points;
  std::uint64_t stamp = 0;  // of the points: another one where they may differ
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  TouchSurface surface;
};

/// All that the haptic loop knows of a scene at one of its moments. Made by the scene's thread, read by the
/// loop's.
struct TouchFrame {
  double duration = 0;  // [s] that the loop takes to get here from the frame before
  std::vector<TouchFrameShape> shapes;
  std::vector<ForceEffect> effects;
  Workspace workspace;
  double tipRadius = 0.0025;    // [m] of the proxy, in the scene
  double forceLimit = -1;       // [N]; negative: the device's own
  bool deadmansSwitch = false;  // force only while the main button is pressed

  std::vector<TouchShape> instants;  // the loop's working space, as many as shapes
};

}  // namespace pleura::haptics
