#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numeric>
#include <random>

#include "golden.h"
#include "shapes.h"
#include <gtest/gtest.h>

#include <pleura/x3d/browser/render/renderer.h>

namespace pleura::render::test {
namespace {

Material glow(const Eigen::Vector3f& color, float transparency = 0) {
  Material m;
  m.lit = false;
  m.emissiveColor = color;
  m.transparency = transparency;
  return m;
}

class RendererTest : public ::testing::Test {
 protected:
  Eigen::Vector3i centerPixel(const DrawList& list) {
    renderer.draw(list, 64, 48);
    const Image image = renderer.readImage();
    return Eigen::Map<const Eigen::Matrix<std::uint8_t, 3, 1>>(image.at(32, 24)).cast<int>();
  }

  std::unique_ptr<GlContext> context = makeOffscreenContext(OffscreenBackend::Osmesa);
  Renderer renderer{*context};
};

/// C = alpha c + (1 - alpha) C, from the farthest to the nearest.
Eigen::Vector3f over(const Eigen::Vector3f& background, const std::vector<DrawItem>& backToFront) {
  Eigen::Vector3f color = background;
  for (const DrawItem& item : backToFront)
    color =
        (1 - item.material.transparency) * item.material.emissiveColor + item.material.transparency * color;
  return 255 * color;
}

TEST_F(RendererTest, TranslucentStackHasTheRightColorInAnyOrder) {
  std::mt19937 random(7);
  std::uniform_real_distribution<float> unit(0, 1);
  Shape plane = rectangle(8, 8);
  plane.geometry.solid = false;
  DrawList list;
  list.background.skyColor = {{0.2f, 0.4f, 0.6f}};
  lookFrom(list, {0, 0, 4});
  std::vector<DrawItem> backToFront;
  for (int i = 0; i < 8; ++i)
    backToFront.push_back({&plane.geometry, translation(0, 0, -1 + 0.001f * static_cast<float>(i)),
                           glow({unit(random), unit(random), unit(random)}, 0.2f + 0.7f * unit(random))});
  const Eigen::Vector3f expected = over(list.background.skyColor[0], backToFront);
  list.items = backToFront;
  for (int trial = 0; trial < 10; ++trial) {
    std::shuffle(list.items.begin(), list.items.end(), random);
    const Eigen::Vector3f error = centerPixel(list).cast<float>() - expected;
    EXPECT_LE(error.cwiseAbs().maxCoeff(), 2) << "order " << trial;
  }
}

TEST_F(RendererTest, CrossingTranslucentPlanesChangeOrderAtTheirCrossing) {
  Shape plane = rectangle(4, 4);
  plane.geometry.solid = false;
  DrawList list;
  lookFrom(list, {0, 0, 6});
  const auto turned = [](float angle) {
    return Eigen::Affine3f(Eigen::AngleAxisf(angle, Eigen::Vector3f::UnitY())).matrix();
  };
  const DrawItem red{&plane.geometry, turned(0.6f), glow({1, 0, 0}, 0.5f)};
  const DrawItem blue{&plane.geometry, turned(-0.6f), glow({0, 0, 1}, 0.5f)};
  list.items = {red, blue};
  renderer.draw(list, 64, 48);
  const Image image = renderer.readImage();
  EXPECT_NEAR(image.at(26, 24)[0], 128, 2);  // on the left, the right-turned red one is nearer
  EXPECT_NEAR(image.at(26, 24)[2], 64, 2);
  EXPECT_NEAR(image.at(38, 24)[0], 64, 2);
  EXPECT_NEAR(image.at(38, 24)[2], 128, 2);
}

TEST_F(RendererTest, OpaqueHidesWhatIsTranslucentBehindIt) {
  const Shape plane = rectangle(8, 8);
  DrawList list;
  lookFrom(list, {0, 0, 4});
  list.items = {{&plane.geometry, translation(0, 0, 1), glow({1, 1, 1}, 0.5f)},
                {&plane.geometry, translation(0, 0, 0), glow({0, 1, 0})},
                {&plane.geometry, translation(0, 0, -1), glow({1, 0, 0}, 0.5f)}};
  EXPECT_TRUE(centerPixel(list).isApprox(Eigen::Vector3i(128, 255, 128)));
}

TEST_F(RendererTest, LambertFollowsTheEquation) {
  const Shape plane = rectangle(8, 8);
  DrawList list;
  list.headlight = false;
  lookFrom(list, {0, 0, 4});
  Light light;
  light.direction = {std::sin(0.8f), 0, -std::cos(0.8f)};
  light.intensity = 0.7f;
  light.ambientIntensity = 0.5f;
  list.lights = {light};
  DrawItem item{&plane.geometry};
  item.material.diffuseColor = {0.6f, 0.4f, 0.9f};
  item.material.ambientIntensity = 0.3f;
  item.material.emissiveColor = {0, 0.1f, 0};
  list.items = {item};
  // I = O_E + I_ia O_a O_D + I_i O_D (N . L)
  const Eigen::Vector3f I =
      item.material.emissiveColor + (0.5f * 0.3f + 0.7f * std::cos(0.8f)) * item.material.diffuseColor;
  EXPECT_LE((centerPixel(list).cast<float>() - 255 * I).cwiseAbs().maxCoeff(), 1);
}

TEST_F(RendererTest, PointLightFadesWithDistanceAndEndsAtItsRadius) {
  const Shape plane = rectangle(8, 8);
  DrawList list;
  list.headlight = false;
  lookFrom(list, {0, 0, 4});
  Light light;
  light.kind = Light::Kind::Point;
  light.location = {0, 0, 2};
  light.attenuation = {0.5f, 0.25f, 0.5f};
  list.lights = {light};
  DrawItem item{&plane.geometry};
  item.material.diffuseColor = Eigen::Vector3f::Ones();
  list.items = {item};
  EXPECT_NEAR(centerPixel(list).x(), 255 / (0.5 + 0.25 * 2 + 0.5 * 4), 2);
  list.lights[0].radius = 1.9f;
  EXPECT_EQ(centerPixel(list).x(), 0);
}

TEST_F(RendererTest, LightsShineOnlyOnTheItemsTheyAreScopedTo) {
  const Shape plane = rectangle(8, 8);
  DrawList list;
  list.headlight = false;
  lookFrom(list, {0, 0, 4});
  list.lights = {Light{}};
  list.items = {{&plane.geometry}};
  list.items[0].lights = 0;
  EXPECT_EQ(centerPixel(list).x(), 0);
  list.headlight = true;  // shines on all
  EXPECT_NEAR(centerPixel(list).x(), 0.8 * 255, 1);
}

TEST_F(RendererTest, BackFacesOfSolidsAreNotDrawnWhateverTheMirroring) {
  Shape plane = rectangle(8, 8);
  DrawList list;
  lookFrom(list, {0, 0, 4});
  const auto shown = [&](const Eigen::Vector3f& scale, bool ccw) {
    plane.geometry.ccw = ccw;
    list.items = {{&plane.geometry, Eigen::Affine3f(Eigen::Scaling(scale)).matrix(), glow({1, 1, 1})}};
    return centerPixel(list).x() == 255;
  };
  EXPECT_TRUE(shown({1, 1, 1}, true));
  EXPECT_TRUE(shown({-1, 1, 1}, true));
  EXPECT_FALSE(shown({1, 1, 1}, false));
  EXPECT_FALSE(shown({-1, 1, -1}, true));  // half a turn
}

TEST_F(RendererTest, SendsAStreamAgainOnlyWhenItsRevisionRises) {
  Shape ball = sphere(1, 8);
  DrawList list;
  lookFrom(list, {0, 0, 4});
  list.items = {{&ball.geometry}, {&ball.geometry, translation(1, 0, 0)}};
  renderer.draw(list, 64, 48);
  EXPECT_EQ(renderer.stats().uploads, 3);
  renderer.draw(list, 64, 48);
  EXPECT_EQ(renderer.stats().uploads, 0);
  for (Eigen::Vector3f& p : ball.positions) p.x() += 10;
  ++ball.geometry.positionsRevision;
  EXPECT_EQ(centerPixel(list), Eigen::Vector3i(0, 0, 0));
  EXPECT_EQ(renderer.stats().uploads, 1);
}

TEST_F(RendererTest, ANewGeometryAtAnOldAddressIsNotTheOldOne) {
  Shape plane = rectangle(8, 8);
  DrawList list;
  lookFrom(list, {0, 0, 4});
  list.items = {{&plane.geometry, translation(0, 0, 0), glow({1, 1, 1})}};
  EXPECT_EQ(centerPixel(list).x(), 255);
  for (Eigen::Vector3f& p : plane.positions) p.x() += 100;
  plane.geometry = Geometry();
  plane.refresh();
  EXPECT_EQ(centerPixel(list).x(), 0);
}

TEST_F(RendererTest, DrawsTheSameBytesEachTime) {
  Shape ball = sphere(1, 32);
  ball.geometry.solid = false;
  DrawList list;
  lookFrom(list, {1, 2, 4});
  list.items = {{&ball.geometry}, {&ball.geometry, translation(0.3f, 0, 0)}};
  for (DrawItem& item : list.items) item.material.transparency = 0.5f;
  renderer.draw(list, 320, 240);
  const Image first = renderer.readImage();
  renderer.draw(list, 320, 240);
  EXPECT_EQ(first.pixels, renderer.readImage().pixels);
}

TEST_F(RendererTest, DepthPeelingDrawsWhatFragmentListsDraw) {
  Shape ball = sphere(1.2f, 32), bar = rod(0.1f, 3);
  ball.geometry.solid = false;
  DrawList list;
  lookFrom(list, {1, 2, 4});
  for (int i = 0; i < 6; ++i) {
    list.items.push_back({&ball.geometry, translation(0.2f * static_cast<float>(i), 0, 0)});
    list.items.back().material.transparency = 0.5f;
    list.items.back().material.diffuseColor = {0.2f * static_cast<float>(i), 0.5f, 1};
  }
  list.items.push_back({&bar.geometry});
  renderer.draw(list, 320, 240);
  const Image byLists = renderer.readImage();
  EXPECT_EQ(renderer.stats().draws, 1 + 6 + 1);  // else OpenGL 4.3 is missing and nothing is compared
  Renderer peeling(*context, {.depthPeeling = true});
  peeling.draw(list, 320, 240);
  const Difference d = difference(byLists, peeling.readImage());
  EXPECT_LE(d.mean, 0.5);  // peeling rounds to 8 bits at each layer
  EXPECT_LE(d.maxTile, 2);
}

TEST_F(RendererTest, MoreFragmentsThanTheListsHoldAtFirstAreAllThere) {
  Shape plane = rectangle(20, 20);
  DrawList list;
  lookFrom(list, {0, 0, 4});
  for (int i = 0; i < 20; ++i)
    list.items.push_back(
        {&plane.geometry, translation(0, 0, 0.01f * static_cast<float>(i)), glow({1, 1, 1}, 0.9f)});
  renderer.draw(list, 400, 300);  // 2.4 million fragments
  const double expected = 255 * (1 - std::pow(0.9, 20));
  for (const auto& [x, y] : {std::pair{0, 0}, std::pair{399, 299}, std::pair{200, 150}})
    EXPECT_NEAR(renderer.readImage().at(x, y)[0], expected, 2);
}

TEST_F(RendererTest, EglDrawsWhatOsmesaDraws) {
  std::unique_ptr<GlContext> egl;
  try {
    egl = makeOffscreenContext(OffscreenBackend::Egl);
  } catch (const std::runtime_error& error) {
    GTEST_SKIP() << error.what();
  }
  Shape ball = sphere(1.2f, 32);
  ball.geometry.solid = false;
  DrawList list;
  lookFrom(list, {1, 2, 4});
  list.background.skyColor = {{0.1f, 0.2f, 0.3f}, {0.5f, 0.5f, 0.5f}};
  list.background.skyAngle = {2};
  list.items = {{&ball.geometry}, {&ball.geometry, translation(0.3f, 0, 0)}};
  list.items[0].material.transparency = 0.5f;
  list.overlay = {{"EGL", 10, 10}};
  Renderer other(*egl);
  other.draw(list, 320, 240);
  const Image image = other.readImage();
  renderer.draw(list, 320, 240);
  const Difference d = difference(image, renderer.readImage());
  EXPECT_LE(d.mean, 0.5);
  EXPECT_LE(d.maxTile, 4);
}

TEST_F(RendererTest, BadValuesAreRefusedByNameAndThePictureStays) {
  Shape ball = sphere(1, 8);
  DrawList good;
  lookFrom(good, {0, 0, 4});
  good.items = {{&ball.geometry}};
  renderer.draw(good, 64, 48);
  const Image before = renderer.readImage();
  const float nan = std::numeric_limits<float>::quiet_NaN(),
              infinity = std::numeric_limits<float>::infinity();
  const auto refuses = [&](const char* name, const std::function<void(DrawList&)>& spoil) {
    DrawList list = good;
    spoil(list);
    try {
      renderer.draw(list, 64, 48);
      ADD_FAILURE() << "accepts a bad " << name;
    } catch (const std::invalid_argument& error) {
      EXPECT_NE(std::string(error.what()).find(name), std::string::npos) << error.what();
    }
    EXPECT_EQ(renderer.readImage().pixels, before.pixels);
  };
  refuses("item.geometry", [](DrawList& list) { list.items[0].geometry = nullptr; });
  refuses("item.model", [&](DrawList& list) { list.items[0].model(1, 3) = nan; });
  refuses("material.transparency", [&](DrawList& list) { list.items[0].material.transparency = 1.5f; });
  refuses("material.diffuseColor",
          [&](DrawList& list) { list.items[0].material.diffuseColor.x() = infinity; });
  refuses("camera.view", [&](DrawList& list) { list.camera.view(0, 0) = nan; });
  refuses("camera.fieldOfView", [&](DrawList& list) { list.camera.fieldOfView = nan; });
  refuses("camera.nearDistance", [](DrawList& list) { list.camera.nearDistance = 0; });
  refuses("camera.farDistance", [](DrawList& list) { list.camera.farDistance = 0; });
  refuses("lights", [](DrawList& list) { list.lights.resize(maxLights + 1); });
  refuses("light.location", [&](DrawList& list) {
    list.lights.resize(1);
    list.lights[0].location.x() = nan;
  });
  refuses("skyAngle", [](DrawList& list) { list.background.skyAngle = {1}; });
  refuses("overlay.size", [](DrawList& list) { list.overlay = {{"x", 0, 0, 1e9f}}; });
  ball.positions[3].y() = nan;
  ++ball.geometry.positionsRevision;
  refuses("geometry.positions", [](DrawList&) {});
  ball.positions[3].y() = 0;
  ball.indices[5] = 1u << 30;
  ++ball.geometry.indicesRevision;
  refuses("geometry.indices", [](DrawList&) {});
  ball.normals.pop_back();
  ball.refresh();
  refuses("geometry.normals", [](DrawList&) {});
  EXPECT_THROW(renderer.draw(good, 0, 48), std::invalid_argument);
}

TEST_F(RendererTest, EmptyGeometryAndEmptyListDrawNothing) {
  const Geometry nothing;
  DrawList list;
  list.background.skyColor = {{0, 1, 0}};
  EXPECT_EQ(centerPixel(list), Eigen::Vector3i(0, 255, 0));
  list.items = {{&nothing}};
  EXPECT_EQ(centerPixel(list), Eigen::Vector3i(0, 255, 0));
  EXPECT_EQ(renderer.stats().uploads, 0);
}

}  // namespace
}  // namespace pleura::render::test
