#include <pleura/nodes/standard/lighting/directional_light.h>
#include <pleura/nodes/standard/lighting/point_light.h>
#include <pleura/nodes/standard/lighting/spot_light.h>
#include <pleura/x3d/browser/view/light.h>

namespace pleura {

namespace {

using Kind = render::Light::Kind;

Vec3f direction(const Matrix4f& toWorld, const Vec3f& local) { return toWorld.topLeftCorner<3, 3>() * local; }

Vec3f place(const Matrix4f& toWorld, const Vec3f& local) {
  return direction(toWorld, local) + toWorld.topRightCorner<3, 1>();
}

template <class PositionalLight>
void setPosition(render::Light& light, PositionalLight& node, const Matrix4f& toWorld) {
  light.location = place(toWorld, node.location.getValue());
  light.attenuation = node.attenuation.getValue();
  light.radius = node.radius.getValue();
}

}  // namespace

std::optional<PlacedLight> placedLight(X3DLightNode& node, const Matrix4f& toWorld) {
  if (!node.on.getValue()) return std::nullopt;
  PlacedLight placed;
  auto& light = placed.light;
  light.color = node.color.getValue();
  light.intensity = node.intensity.getValue();
  light.ambientIntensity = node.ambientIntensity.getValue();
  if (auto* sun = dynamic_cast<DirectionalLight*>(&node)) {
    light.kind = Kind::Directional;
    light.direction = direction(toWorld, sun->direction.getValue());
    placed.isGlobal = sun->global.getValue();
  } else if (auto* spot = dynamic_cast<SpotLight*>(&node)) {
    light.kind = Kind::Spot;
    setPosition(light, *spot, toWorld);
    light.direction = direction(toWorld, spot->direction.getValue());
    light.beamWidth = spot->beamWidth.getValue();
    light.cutOffAngle = spot->cutOffAngle.getValue();
    placed.isGlobal = spot->global.getValue();
  } else if (auto* point = dynamic_cast<PointLight*>(&node)) {
    light.kind = Kind::Point;
    setPosition(light, *point, toWorld);
    placed.isGlobal = point->global.getValue();
  }
  return placed;
}

}  // namespace pleura
