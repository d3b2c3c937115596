#include <array>

#include <Eigen/Geometry>

#include <pleura/x3d/browser/render/light_buffer.h>

namespace pleura::render {
namespace {

struct ShaderLight {  // std140
  Eigen::Vector4f colorIntensity;
  Eigen::Vector4f directionKind;
  Eigen::Vector4f locationRadius;
  Eigen::Vector4f attenuationAmbient;
  Eigen::Vector4f beamWidthCutOffAngle;
};

Eigen::Vector4f join(const Eigen::Vector3f& xyz, float w) { return {xyz.x(), xyz.y(), xyz.z(), w}; }

ShaderLight inViewSpace(const Light& light, const Eigen::Matrix4f& view) {
  const Eigen::Vector3f direction = view.topLeftCorner<3, 3>() * light.direction;
  const Eigen::Vector3f location = (view * light.location.homogeneous()).head<3>();
  return {join(light.color, light.intensity),
          join(direction.stableNormalized(), static_cast<float>(light.kind)),
          join(location, light.radius),
          join(light.attenuation, light.ambientIntensity),
          {light.beamWidth, light.cutOffAngle, 0, 0}};
}

}  // namespace

int LightBuffer::update(const DrawList& list) {
  std::array<ShaderLight, maxLights + 1> lights{};
  std::size_t count = 0;
  for (const Light& light : list.lights) lights[count++] = inViewSpace(light, list.camera.view);
  if (list.headlight) lights[count++] = inViewSpace(Light{}, Eigen::Matrix4f::Identity());
  gl_.BindBuffer(GL_UNIFORM_BUFFER, buffer_);
  gl_.BufferData(GL_UNIFORM_BUFFER, sizeof(lights), lights.data(), GL_STREAM_DRAW);
  gl_.BindBufferBase(GL_UNIFORM_BUFFER, binding, buffer_);
  return static_cast<int>(count);
}

}  // namespace pleura::render
