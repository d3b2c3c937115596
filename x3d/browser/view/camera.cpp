#include <cmath>
#include <numbers>

#include <pleura/nodes/standard/navigation/ortho_viewpoint.h>
#include <pleura/nodes/standard/navigation/viewpoint.h>
#include <pleura/x3d/browser/view/camera.h>

namespace pleura {

namespace {

/// Half the diagonal; 0 for a box that is empty or larger than numbers go.
float radiusOf(const Eigen::AlignedBox3f& box) {
  const float radius = box.isEmpty() ? 0 : std::max(1e-6f, box.diagonal().norm() / 2);
  return std::isfinite(radius) ? radius : 0;
}

/// Depth range that holds the box with some room, not so near that depth loses its precision.
void fitDepth(render::Camera& camera, const Eigen::AlignedBox3f& box) {
  const float radius = radiusOf(box);
  if (radius == 0) return;
  const Vec3f center = camera.view.topLeftCorner<3, 3>() * box.center() + camera.view.topRightCorner<3, 1>();
  camera.farDistance = std::max(-center.z() + 1.5f * radius, 4 * radius);
  camera.nearDistance = std::max(-center.z() - 1.5f * radius, camera.farDistance / 2000);
}

}  // namespace

PlacedCamera placedCamera(X3DViewpointNode& node, const Matrix4f& toWorld, const Eigen::AlignedBox3f& box) {
  PlacedCamera placed;
  Vec3f position = Vec3f(0, 0, 10);
  if (auto* perspective = dynamic_cast<Viewpoint*>(&node)) {
    position = perspective->position.getValue();
    placed.camera.fieldOfView = perspective->fieldOfView.getValue();
    placed.centerOfRotation = perspective->centerOfRotation.getValue();
  } else if (auto* ortho = dynamic_cast<OrthoViewpoint*>(&node)) {
    position = ortho->position.getValue();
    placed.centerOfRotation = ortho->centerOfRotation.getValue();
    if (const auto& extent = ortho->fieldOfView.getValue(); extent.size() >= 4)
      placed.camera.orthographic = render::OrthographicExtent{extent[0], extent[1], extent[2], extent[3]};
  }
  Matrix4f local = Matrix4f::Identity();
  local.topLeftCorner<3, 3>() = node.orientation.getValue().quaternion().toRotationMatrix();
  local.topRightCorner<3, 1>() = position;
  placed.camera.view = (toWorld * local).inverse();
  const Vec3f center = placed.centerOfRotation;
  placed.centerOfRotation = toWorld.topLeftCorner<3, 3>() * center + toWorld.topRightCorner<3, 1>();
  fitDepth(placed.camera, box);
  if (const float asked = node.nearDistance.getValue(); asked > 0) placed.camera.nearDistance = asked;
  if (const float asked = node.farDistance.getValue(); asked > 0) placed.camera.farDistance = asked;
  return placed;
}

Vec3f viewerIn(const Matrix4f& toView) {
  const Matrix3f axes = toView.topLeftCorner<3, 3>();
  if (std::abs(axes.determinant()) < 1e-12f) return Vec3f::Zero();
  return axes.inverse() * -toView.topRightCorner<3, 1>();
}

PlacedCamera cameraFor(const Eigen::AlignedBox3f& box) {
  PlacedCamera placed;
  placed.camera.fieldOfView = std::numbers::pi_v<float> / 4;
  Vec3f position(0, 0, 10);
  if (const float radius = radiusOf(box); radius > 0) {
    placed.centerOfRotation = box.center();
    position = box.center() + Vec3f(0, 0, radius / std::sin(placed.camera.fieldOfView / 2));
  }
  placed.camera.view.topRightCorner<3, 1>() = -position;
  fitDepth(placed.camera, box);
  return placed;
}

}  // namespace pleura
