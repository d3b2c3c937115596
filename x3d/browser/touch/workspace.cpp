#include <cmath>

#include <pleura/nodes/standard/navigation/viewpoint.h>
#include <pleura/x3d/browser/touch/workspace.h>

namespace pleura {

namespace {

/// Before the viewer: turned as the camera, around what the viewer turns about.
Eigen::Isometry3d beforeViewer(X3DViewpointNode& node, const Matrix4f& toWorld) {
  const Eigen::Affine3f world(toWorld);
  Eigen::Isometry3d placement = Eigen::Isometry3d::Identity();
  const Eigen::Matrix3f turn = world.rotation() * node.orientation.getValue().quaternion().toRotationMatrix();
  placement.linear() = Eigen::Quaterniond(turn.cast<double>()).normalized().toRotationMatrix();
  if (auto* viewpoint = dynamic_cast<Viewpoint*>(&node))
    placement.translation() = (world * viewpoint->centerOfRotation.getValue()).cast<double>();
  return placement;
}

}  // namespace

haptics::Workspace workspaceOf(HapticsDeviceNode& device, X3DViewpointNode* viewpoint,
                               const Matrix4f& viewpointToWorld) {
  const Eigen::Affine3d calibration(device.positionCalibration.getValue().cast<double>());
  const double stretch = std::cbrt(std::abs(calibration.linear().determinant()));
  haptics::Workspace workspace;
  if (!calibration.matrix().allFinite() || !(stretch > 0)) return workspace;
  workspace.scale = stretch * device.workspaceScale.getValue();
  workspace.placement.linear() = Eigen::Quaterniond(calibration.rotation()).normalized().toRotationMatrix();
  workspace.placement.translation() = calibration.translation();
  if (device.followViewpoint.getValue() && viewpoint != nullptr)
    workspace.placement = beforeViewer(*viewpoint, viewpointToWorld) * workspace.placement;
  return workspace;
}

}  // namespace pleura
