#include "golden.h"

#include <numbers>

#include "shapes.h"
#include <gtest/gtest.h>

namespace pleura::render::test {
namespace {

constexpr float kPi = std::numbers::pi_v<float>;

Material colored(float r, float g, float b, float transparency = 0) {
  Material m;
  m.diffuseColor = {r, g, b};
  m.transparency = transparency;
  return m;
}

DrawList gray() {
  DrawList list;
  list.background.skyColor = {Eigen::Vector3f::Constant(0.25f)};
  lookFrom(list, {0, 0, 4});
  return list;
}

TEST(Golden, LitSphereIsSmoothWithAHighlight) {
  const Shape ball = sphere(1, 24);
  DrawList list = gray();
  Material m = colored(0.8f, 0.3f, 0.25f);
  m.specularColor = Eigen::Vector3f::Constant(0.6f);
  m.shininess = 0.4f;
  list.items = {{&ball.geometry, translation(0, 0, 0), m}};
  expectGolden(drawGolden(list), "lit_sphere");
}

TEST(Golden, OpenSheetIsLitOnBothSides) {
  const Shape sheet = trough(1, 2.4f);
  DrawList list = gray();
  lookFrom(list, {2.8f, 2, 1.6f});
  list.items = {{&sheet.geometry, translation(0, 0.4f, 0), colored(0.3f, 0.6f, 0.8f)}};
  expectGolden(drawGolden(list), "two_sided_sheet");
}

TEST(Golden, NestedTranslucentSpheresAndRods) {
  Shape outer = sphere(1.2f, 32), inner = sphere(0.7f, 32);
  outer.geometry.solid = inner.geometry.solid = false;
  const Shape bar = rod(0.12f, 3);
  DrawList list = gray();
  list.items = {{&outer.geometry, translation(0, 0, 0), colored(0.9f, 0.5f, 0.5f, 0.6f)},
                {&inner.geometry, translation(0.2f, 0, 0), colored(0.3f, 0.4f, 0.9f, 0.5f)},
                {&bar.geometry, translation(-0.5f, 0, 1.3f), colored(0.9f, 0.9f, 0.8f)},
                {&bar.geometry, translation(0.2f, 0, 0), colored(0.2f, 0.9f, 0.3f)},
                {&bar.geometry, translation(0.7f, 0, -1.4f), colored(0.9f, 0.8f, 0.2f)}};
  expectGolden(drawGolden(list), "translucent_nested");
}

TEST(Golden, SkyAndGroundGradient) {
  DrawList list;
  list.background.skyColor = {{0, 0, 0.4f}, {0.3f, 0.5f, 0.9f}, {0.9f, 0.9f, 1}};
  list.background.skyAngle = {kPi / 2 - 0.3f, kPi / 2};
  list.background.groundColor = {{0.1f, 0.05f, 0}, {0.4f, 0.6f, 0.2f}};
  list.background.groundAngle = {kPi / 2 - 0.05f};
  list.camera.fieldOfView = 1.2f;
  expectGolden(drawGolden(list), "background");
}

TEST(Golden, MultisampledEdges) {
  const Shape card = rectangle(2, 2);
  DrawList list;
  lookFrom(list, {0, 0, 4});
  const Eigen::Affine3f tilt(Eigen::AngleAxisf(0.2f, Eigen::Vector3f::UnitZ()));
  Material white;
  white.lit = false;
  white.emissiveColor = Eigen::Vector3f::Ones();
  list.items = {{&card.geometry, tilt.matrix(), white}};
  expectGolden(drawGolden(list), "edges");
}

TEST(Golden, PointSpotAndDirectionalLights) {
  const Shape ball = sphere(0.6f, 24), wall = rectangle(6, 4);
  DrawList list;
  lookFrom(list, {0, 0, 5});
  list.headlight = false;
  Light directional, point, spot;
  directional.color = {1, 0.2f, 0.2f};
  directional.direction = {1, -1, -0.5f};
  directional.intensity = 0.5f;
  point.kind = Light::Kind::Point;
  point.color = {0.3f, 0.4f, 1};
  point.location = {1.3f, 0.6f, 0.8f};
  point.attenuation = {1, 0, 0.5f};
  spot.kind = Light::Kind::Spot;
  spot.color = {0.4f, 1, 0.3f};
  spot.location = {-0.5f, -0.8f, 1.5f};
  spot.direction = {-0.2f, 0, -1};
  spot.beamWidth = 0.2f;
  spot.cutOffAngle = 0.4f;
  list.lights = {directional, point, spot};
  list.items = {{&ball.geometry, translation(0, 0, 0), colored(0.9f, 0.9f, 0.9f)},
                {&wall.geometry, translation(0, 0, -0.8f), colored(0.7f, 0.7f, 0.7f)}};
  expectGolden(drawGolden(list), "lights");
}

}  // namespace
}  // namespace pleura::render::test
