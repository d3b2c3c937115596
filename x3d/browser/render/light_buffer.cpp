#include <array>

#include <Eigen/Geometry>

#include <pleura/x3d/browser/render/light_buffer.h>

namespace pleura::render {
namespace {

struct ShaderLight {  // std140
  Eigen::Vector4f colorIntensity;
  Eigen::Vector4f direction;
  Eigen::Vector4f locationRadius;
  Eigen::Vector4f attenuationAmbient;
  Eigen::Vector4f beamWidthCutOffAngle;
};

Eigen::Vector4f join(const Eigen::Vector3f& xyz, float w) { return {xyz.x(), xyz.y(), xyz.z(), w}; }

ShaderLight inViewSpace(const Light& light, const Eigen::Matrix4f& view) {
  const Eigen::Vector3f direction = view.topLeftCorner<3, 3>() * light.direction;
  const Eigen::Vector3f location = (view * light.location.homogeneous()).head<3>();
  return {join(light.color, light.intensity),
          join(direction.stableNormalized(), 0),
          join(location, light.radius),
          join(light.attenuation, light.ambientIntensity),
          {light.beamWidth, light.cutOffAngle, 0, 0}};
}

}  // namespace

LightKinds LightBuffer::update(const DrawList& list) {
  std::array<ShaderLight, maxLights + 1> lights{};
  LightKinds kinds;
  for (const Light& light : list.lights) {
    lights[kinds.size()] = inViewSpace(light, list.camera.view);
    kinds.push_back(light.kind);
  }
  if (list.headlight) {
    lights[kinds.size()] = inViewSpace(Light{}, Eigen::Matrix4f::Identity());
    kinds.push_back(Light::Kind::Directional);
  }
  gl_.BindBuffer(GL_UNIFORM_BUFFER, buffer_);
  gl_.BufferData(GL_UNIFORM_BUFFER, sizeof(lights), lights.data(), GL_STREAM_DRAW);
  gl_.BindBufferBase(GL_UNIFORM_BUFFER, binding, buffer_);
  return kinds;
}

}  // namespace pleura::render
