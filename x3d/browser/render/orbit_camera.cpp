#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include <pleura/x3d/browser/render/orbit_camera.h>

namespace pleura::render {
namespace {

constexpr float pi = std::numbers::pi_v<float>;
constexpr float poleElevation = 0.49f * pi;
constexpr float zoomFactor = 0.9f;  // a step of the wheel
constexpr float fitMargin = 1.05f;

/// Width of a pixel at distance `depth` [m].
float metresPerPixel(const Camera& camera, float depth, float width, float height) {
  if (camera.orthographic) {
    const OrthographicExtent& e = *camera.orthographic;
    return std::max((e.right - e.left) / width, (e.top - e.bottom) / height);
  }
  return 2 * depth * std::tan(camera.fieldOfView / 2) / std::min(width, height);
}

void scale(OrthographicExtent& e, float factor) {
  const float x = (e.left + e.right) / 2, y = (e.bottom + e.top) / 2;
  e = {x + (e.left - x) * factor, y + (e.bottom - y) * factor, x + (e.right - x) * factor,
       y + (e.top - y) * factor};
}

}  // namespace

OrbitCamera::OrbitCamera(const Camera& viewpoint, const Eigen::Vector3f& center)
    : viewpoint_(viewpoint), camera_(viewpoint), viewpointCenter_(center), center_(center) {
  if (!viewpoint.view.allFinite()) throw std::invalid_argument("viewpoint.view is not finite");
  if (!center.allFinite()) throw std::invalid_argument("center is not finite");
}

Eigen::Vector3f OrbitCamera::centerInView() const { return (camera_.view * center_.homogeneous()).head<3>(); }

void OrbitCamera::move(const Eigen::Vector3f& offset) { camera_.view.topRightCorner<3, 1>() += offset; }

void OrbitCamera::orbit(float pixelsX, float pixelsY, int pictureHeight) {
  const float perPixel = pi / static_cast<float>(std::max(pictureHeight, 1));
  const Eigen::Matrix3f rotation = camera_.view.topLeftCorner<3, 3>();
  const float elevation = std::asin(std::clamp(rotation(2, 1), -1.0f, 1.0f));
  const float limit = std::max(poleElevation, std::abs(elevation));
  const float pitch = std::clamp(elevation + pixelsY * perPixel, -limit, limit) - elevation;
  const Eigen::Quaternionf turned = Eigen::AngleAxisf(pitch, Eigen::Vector3f::UnitX()) *
                                    Eigen::Quaternionf(rotation) *
                                    Eigen::AngleAxisf(pixelsX * perPixel, Eigen::Vector3f::UnitY());
  const Eigen::Vector3f before = centerInView();
  camera_.view.topLeftCorner<3, 3>() = turned.normalized().toRotationMatrix();
  move(before - centerInView());
}

void OrbitCamera::pan(float pixelsX, float pixelsY, int pictureWidth, int pictureHeight) {
  const float size = metresPerPixel(camera_, -centerInView().z(), static_cast<float>(pictureWidth),
                                    static_cast<float>(pictureHeight));
  const Eigen::Vector3f offset = size * Eigen::Vector3f(pixelsX, -pixelsY, 0);
  move(offset);
  center_ -= camera_.view.topLeftCorner<3, 3>().transpose() * offset;
}

void OrbitCamera::zoom(float steps) {
  const float factor = std::pow(zoomFactor, std::clamp(steps, -100.0f, 100.0f));
  if (camera_.orthographic) return scale(*camera_.orthographic, factor);
  move((factor - 1) * centerInView());
  camera_.nearDistance = std::min(viewpoint_.nearDistance, centerInView().norm() / 100);
}

void OrbitCamera::fit(const Eigen::AlignedBox3f& box) {
  if (box.isEmpty() || !box.min().allFinite() || !box.max().allFinite())
    throw std::invalid_argument("box is empty or not finite");
  const float radius = fitMargin * std::max(box.diagonal().norm() / 2, 1e-6f);
  center_ = box.center();
  float distance = 2 * radius;
  if (camera_.orthographic)
    camera_.orthographic = {-radius, -radius, radius, radius};
  else
    distance = radius / std::sin(camera_.fieldOfView / 2);
  move(Eigen::Vector3f(0, 0, -distance) - centerInView());
  camera_.nearDistance = std::min(viewpoint_.nearDistance, distance / 100);
  camera_.farDistance = std::max(viewpoint_.farDistance, distance + radius);
}

void OrbitCamera::reset() {
  camera_ = viewpoint_;
  center_ = viewpointCenter_;
}

}  // namespace pleura::render
