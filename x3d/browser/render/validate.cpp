#include <algorithm>
#include <cmath>
#include <span>

#include <pleura/x3d/browser/render/background_pass.h>
#include <pleura/x3d/browser/render/projection.h>
#include <pleura/x3d/browser/render/require.h>
#include <pleura/x3d/browser/render/validate.h>

namespace pleura::render {
namespace {

template <class Value>
void requireFinite(const Value& value, const char* name) {
  require(value.allFinite(), "{} is not finite", name);
}

void requireFinite(float value, const char* name) { require(std::isfinite(value), "{} is not finite", name); }

void requireFraction(float value, const char* name) {
  require(value >= 0 && value <= 1, "{} is {}, outside [0, 1]", name, value);
}

template <class Value>
void requireFiniteStream(std::span<const Value> values, const char* name) {
  const bool isFinite = std::ranges::all_of(values, [](const Value& value) { return value.allFinite(); });
  require(isFinite, "geometry.{} holds a value that is not finite", name);
}

void checkStops(const std::vector<Eigen::Vector3f>& colors, const std::vector<float>& angles,
                const char* name) {
  require(colors.size() <= BackgroundPass::maxStops, "background.{}Color has {} colors, more than {}", name,
          colors.size(), BackgroundPass::maxStops);
  require(angles.size() + 1 == colors.size() || (angles.empty() && colors.empty()),
          "background.{0}Color needs one value more than {0}Angle", name);
  for (const Eigen::Vector3f& color : colors) requireFinite(color, "background colour");
  for (const float angle : angles) requireFinite(angle, "background angle");
  require(std::ranges::is_sorted(angles), "background.{}Angle does not rise", name);
}

}  // namespace

void validate(const Geometry& geometry) {
  requireFiniteStream(geometry.positions, "positions");
  requireFiniteStream(geometry.normals, "normals");
  requireFiniteStream(geometry.colors, "colors");
  if (geometry.indices.empty()) return;
  const std::uint32_t largest = *std::ranges::max_element(geometry.indices);
  require(largest < geometry.positions.size(), "geometry.indices has {}, but there are {} positions", largest,
          geometry.positions.size());
}

void validate(const DrawItem& item) {
  require(item.geometry != nullptr, "item.geometry is null");
  requireFinite(item.model, "item.model");
  const Material& m = item.material;
  requireFinite(m.diffuseColor, "material.diffuseColor");
  requireFinite(m.specularColor, "material.specularColor");
  requireFinite(m.emissiveColor, "material.emissiveColor");
  requireFraction(m.ambientIntensity, "material.ambientIntensity");
  requireFraction(m.shininess, "material.shininess");
  requireFraction(m.transparency, "material.transparency");
  require(item.size > 0 && std::isfinite(item.size), "item.size must be above 0");
}

void validate(const Light& light) {
  requireFinite(light.color, "light.color");
  requireFinite(light.intensity, "light.intensity");
  requireFinite(light.ambientIntensity, "light.ambientIntensity");
  requireFinite(light.direction, "light.direction");
  requireFinite(light.location, "light.location");
  requireFinite(light.attenuation, "light.attenuation");
  requireFinite(light.radius, "light.radius");
  requireFinite(light.beamWidth, "light.beamWidth");
  requireFinite(light.cutOffAngle, "light.cutOffAngle");
}

void validate(const Camera& camera) {
  requireFinite(camera.view, "camera.view");
  projectionMatrix(camera, 1, 1);
}

void validate(const Background& background) {
  require(!background.skyColor.empty(), "background.skyColor is empty");
  checkStops(background.skyColor, background.skyAngle, "sky");
  checkStops(background.groundColor, background.groundAngle, "ground");
  requireFinite(background.rotation, "background.rotation");
}

void validate(const DrawList& list) {
  for (const DrawItem& item : list.items) validate(item);
  require(list.lights.size() <= maxLights, "there are {} lights, more than {}", list.lights.size(),
          maxLights);
  for (const Light& light : list.lights) validate(light);
  requireFinite(list.camera.view, "camera.view");
  validate(list.background);
  for (const OverlayText& text : list.overlay) {
    require(text.size >= 4 && text.size <= 512, "overlay.size is outside [4, 512]");
    requireFinite(text.color, "overlay.color");
    require(std::isfinite(text.x) && std::isfinite(text.y), "overlay position is not finite");
  }
}

}  // namespace pleura::render
