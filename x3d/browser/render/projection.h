#pragma once

#include <optional>

#include <Eigen/Core>

#include <pleura/x3d/browser/render/draw_list.h>

namespace pleura::render {

/// View space to OpenGL clip space for a picture of width x height [pixel]. X3D's fieldOfView spans the
/// smaller side, an orthographic extent is fitted in whole. Throws std::invalid_argument that names the bad
/// field of the camera.
Eigen::Matrix4f projectionMatrix(const Camera& camera, int width, int height);

/// Where a point of the world stands in the picture [pixel from the top left]; nothing if it is behind the
/// camera.
std::optional<Eigen::Vector2f> projectToPicture(const Camera& camera, int width, int height,
                                                const Eigen::Vector3f& point);

}  // namespace pleura::render
