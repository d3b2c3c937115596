#include <numbers>

#include <pleura/x3d/browser/render/background_pass.h>
#include <pleura/x3d/browser/render/projection.h>
#include <pleura/x3d/browser/render/shaders.h>

namespace pleura::render {
namespace {

/// Each colour with the angle at which it is pure; the first stands at the pole.
std::vector<Eigen::Vector4f> stops(const std::vector<Eigen::Vector3f>& colors,
                                   const std::vector<float>& angles) {
  std::vector<Eigen::Vector4f> result;
  for (std::size_t i = 0; i < colors.size(); ++i)
    result.emplace_back(colors[i].x(), colors[i].y(), colors[i].z(), i == 0 ? 0.0f : angles[i - 1]);
  return result;
}

/// A single ground colour covers the lower half.
std::vector<Eigen::Vector4f> groundStops(const Background& background) {
  auto result = stops(background.groundColor, background.groundAngle);
  if (result.size() == 1) {
    result.push_back(result.front());
    result.back().w() = std::numbers::pi_v<float> / 2;
  }
  return result;
}

Camera perspectiveOf(const Camera& camera) {
  Camera result = camera;
  if (camera.orthographic) result.fieldOfView = std::numbers::pi_v<float> / 4;
  result.orthographic.reset();
  result.nearDistance = 1;
  result.farDistance = 2;
  return result;
}

}  // namespace

BackgroundPass::BackgroundPass(const GlFunctions& gl, const std::string& header)
    : gl_(gl),
      program_(gl, header + "#define STOPS " + std::to_string(maxStops) + "\n", shaders::backgroundVertex,
               shaders::backgroundFragment),
      noVertices_(gl) {}

void BackgroundPass::draw(const Background& background, const Camera& camera, int width, int height) const {
  if (background.skyColor.size() == 1 && background.groundColor.empty()) return;
  const auto sky = stops(background.skyColor, background.skyAngle), ground = groundStops(background);
  const Eigen::Matrix4f projection = projectionMatrix(perspectiveOf(camera), width, height);
  const Eigen::Matrix3f rotation =
      background.rotation.transpose() * camera.view.topLeftCorner<3, 3>().transpose();
  program_.use();
  gl_.Uniform2f(program_.uniform("tangents"), 1 / projection(0, 0), 1 / projection(1, 1));
  gl_.UniformMatrix3fv(program_.uniform("rotation"), 1, GL_FALSE, rotation.data());
  gl_.Uniform1i(program_.uniform("skyCount"), static_cast<GLint>(sky.size()));
  gl_.Uniform1i(program_.uniform("groundCount"), static_cast<GLint>(ground.size()));
  gl_.Uniform4fv(program_.uniform("sky"), static_cast<GLsizei>(sky.size()), sky.front().data());
  if (!ground.empty())
    gl_.Uniform4fv(program_.uniform("ground"), static_cast<GLsizei>(ground.size()), ground.front().data());
  gl_.Disable(GL_CULL_FACE);
  gl_.BindVertexArray(noVertices_);
  gl_.DrawArrays(GL_TRIANGLES, 0, 3);
}

}  // namespace pleura::render
