#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>

#include <pleura/x3d/browser/render/projection.h>
#include <pleura/x3d/browser/render/require.h>

namespace pleura::render {
namespace {

Eigen::Matrix4f perspective(const Camera& camera, float width, float height) {
  require(camera.fieldOfView > 0 && camera.fieldOfView < 3.1415926f,
          "camera.fieldOfView must be inside (0, pi)");
  require(camera.nearDistance > 0, "camera.nearDistance must be above 0");
  const float n = camera.nearDistance, f = camera.farDistance;
  const float scale = 1 / std::tan(camera.fieldOfView / 2), smaller = std::min(width, height);
  Eigen::Matrix4f projection = Eigen::Matrix4f::Zero();
  projection(0, 0) = scale * smaller / width;
  projection(1, 1) = scale * smaller / height;
  projection(2, 2) = (n + f) / (n - f);
  projection(2, 3) = 2 * n * f / (n - f);
  projection(3, 2) = -1;
  return projection;
}

Eigen::Matrix4f orthographic(const Camera& camera, float width, float height) {
  const OrthographicExtent& e = *camera.orthographic;
  const float extentX = e.right - e.left, extentY = e.top - e.bottom;
  require(extentX > 0 && extentY > 0 && std::isfinite(extentX + extentY),
          "camera.orthographic must have an extent");
  const float metresPerPixel = std::max(extentX / width, extentY / height);
  const float n = camera.nearDistance, f = camera.farDistance;
  Eigen::Matrix4f projection = Eigen::Matrix4f::Identity();
  projection(0, 0) = 2 / (metresPerPixel * width);
  projection(1, 1) = 2 / (metresPerPixel * height);
  projection(2, 2) = 2 / (n - f);
  projection(0, 3) = -projection(0, 0) * (e.left + e.right) / 2;
  projection(1, 3) = -projection(1, 1) * (e.bottom + e.top) / 2;
  projection(2, 3) = (n + f) / (n - f);
  return projection;
}

}  // namespace

Eigen::Matrix4f projectionMatrix(const Camera& camera, int width, int height) {
  require(camera.farDistance > camera.nearDistance && std::isfinite(camera.farDistance) &&
              std::isfinite(camera.nearDistance),
          "camera.farDistance must be finite and beyond camera.nearDistance");
  const auto w = static_cast<float>(width), h = static_cast<float>(height);
  return camera.orthographic ? orthographic(camera, w, h) : perspective(camera, w, h);
}

std::optional<Eigen::Vector2f> projectToPicture(const Camera& camera, int width, int height,
                                                const Eigen::Vector3f& point) {
  const Eigen::Vector4f clip = projectionMatrix(camera, width, height) * (camera.view * point.homogeneous());
  if (clip.w() <= 0) return std::nullopt;
  const Eigen::Vector2f ndc = clip.head<2>() / clip.w();
  return Eigen::Vector2f((1 + ndc.x()) / 2 * static_cast<float>(width),
                         (1 - ndc.y()) / 2 * static_cast<float>(height));
}

}  // namespace pleura::render
