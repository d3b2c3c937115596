#pragma once

#include <Eigen/Geometry>

#include <pleura/nodes/standard/navigation/x3d_viewpoint_node.h>
#include <pleura/x3d/browser/render/draw_list.h>

namespace pleura {

/// The camera of a viewpoint that stands in a group of that transform, with the point it turns about, in
/// world space.
struct PlacedCamera {
  render::Camera camera;
  Vec3f centerOfRotation = Vec3f::Zero();
};

/// Near and far are fitted to `box`, what there is to see, where the viewpoint does not say.
PlacedCamera placedCamera(X3DViewpointNode& node, const Matrix4f& toWorld, const Eigen::AlignedBox3f& box);

/// Where the viewer stands in a frame, given the frame's transform to view space; its origin where that is
/// flat.
Vec3f viewerIn(const Matrix4f& toView);

/// From the front, so that the whole box is seen; X3D's default viewpoint for an empty one.
PlacedCamera cameraFor(const Eigen::AlignedBox3f& box);

}  // namespace pleura
