#include <map>

#include "touched_scene.h"
#include <gtest/gtest.h>

#include <pleura/nodes/deformable/geometry_mesh.h>
#include <pleura/nodes/deformable/mesh/surface_query.h>
#include <pleura/nodes/standard/rendering/coordinate.h>
#include <pleura/nodes/standard/rendering/x3d_composed_geometry_node.h>
#include <pleura/nodes/standard/shape/shape.h>
#include <pleura/nodes/thorax/deformable_shape2.h>
#include <pleura/x3d/browser/scene/traversal.h>

namespace pleura {
namespace {

/// The breathing thorax, and a stylus whose hand goes to a place and rests there.
class TouchedThorax : public ::testing::Test {
 protected:
  void load() { scene.load(std::filesystem::path(PLEURA_SOURCE_DIR) / "scenes/breathing_thorax.x3d"); }

  std::filesystem::path path(const std::string& text) { return folder.write("path.csv", text); }

  float number(const std::string& field) { return valueOf<SFFloat>(scene, field); }
  Vec3f vector(const std::string& field) { return valueOf<SFVec3f>(scene, field); }
  std::string touched() { return valueOf<SFString>(scene, "STYLUS.touched"); }

  const TemporaryFolder folder;
  Scene scene;
};

// From the front between left ribs 4 and 5 onto the lung, as in scenes/touch_thorax.csv.
constexpr auto kOntoLung = "0,0.15,0.03,0.12\n1,0.097,0.029,0.068\n2,0.090,0.029,0.061\n";
constexpr auto kOntoRib = "0,0.13,0.06,0.09\n1,0.0965,0.052,0.0565\n";
// From below onto the diaphragm's right dome.
constexpr auto kOntoDiaphragm = "0,-0.08,-0.16,0\n1,-0.08,-0.1,0\n3,-0.08,0.03,0\n";

TEST_F(TouchedThorax, PartsAreNamed) {
  for (const auto& [way, part, title] :
       std::vector<std::array<std::string, 3>>{{kOntoRib, "RIB_L4", "Left rib 4"},
                                               {kOntoLung, "LUNG_L", "Left lung"},
                                               {kOntoDiaphragm, "DIAPHRAGM", "Diaphragm"}}) {
    Scene breathing;
    breathing.load(std::filesystem::path(PLEURA_SOURCE_DIR) / "scenes/breathing_thorax.x3d");
    Playback playback(breathing, {.touch = {.stylus = path(way)}});
    playback.runUntil(4);
    EXPECT_EQ(valueOf<SFString>(breathing, "STYLUS.touched"), part);
    EXPECT_EQ(valueOf<MFString>(breathing, "STYLUS.label"), std::vector<std::string>{title});
  }
}

TEST_F(TouchedThorax, WhatIsSeenToGiveWayIsWhatIsFelt) {
  load();
  Playback playback(scene, {.touch = {.stylus = path(kOntoLung)}});
  auto& lung = dynamic_cast<DeformableShape2&>(scene.node("LUNG_L"));
  int touches = 0;
  playback.runUntil(8, [&](Time now) {
    if (touched() != "LUNG_L") return;
    ++touches;
    const auto& point = lung.geometry.get()->contactPoint.getValue().at(0);
    const auto& normal = lung.geometry.get()->contactNormal.getValue().at(0);
    const double felt = lung.geometry.get()->contactDepth.getValue().at(0);
    const SurfaceQuery seen(lung.touchedCoord.getValue(), lung.untouchedTriangles());
    const Vec3d outside = point.cast<double>() + 0.001 * normal.cast<double>();
    const auto hit = seen.intersectRay(outside, -normal.cast<double>(), 0.1);
    ASSERT_TRUE(hit) << now;
    EXPECT_NEAR(hit->distance - 0.001, felt, 0.0002) << now;
  });
  EXPECT_GT(touches, 100);
}

TEST_F(TouchedThorax, BoneLungAndDiaphragmFeelDifferent) {
  // A slow poke into the paused thorax: stiffness is what the force grows by with depth.
  const auto stiffness = [this](const std::string& way, const std::string& part) {
    Scene still;
    still.load(std::filesystem::path(PLEURA_SOURCE_DIR) / "scenes/breathing_thorax.x3d");
    Playback playback(still, {.set = {"BREATH.paused=true"}, .touch = {.stylus = path(way)}});
    std::vector<std::pair<double, double>> samples;
    playback.runUntil(6, [&](Time) {
      const double depth = valueOf<SFFloat>(still, "STYLUS.depth");
      if (valueOf<SFString>(still, "STYLUS.touched") == part && depth > 0.0003)
        samples.emplace_back(depth, valueOf<SFVec3f>(still, "STYLUS.force").norm());
    });
    EXPECT_GT(samples.size(), 20u) << part;
    return samples.empty() ? 0 : samples.back().second / samples.back().first;
  };
  const double bone = stiffness("0,0.13,0.06,0.09\n1,0.1,0.053,0.06\n5,0.0965,0.052,0.0565\n", "RIB_L4");
  const double lung = stiffness("0,0.15,0.03,0.12\n1,0.097,0.029,0.068\n5,0.090,0.029,0.061\n", "LUNG_L");
  const double diaphragm = stiffness(kOntoDiaphragm, "DIAPHRAGM");
  RecordProperty("bone_N_per_m", static_cast<int>(bone));
  RecordProperty("lung_N_per_m", static_cast<int>(lung));
  RecordProperty("diaphragm_N_per_m", static_cast<int>(diaphragm));
  EXPECT_NEAR(bone, 400, 40) << "2 b / T of the device";
  EXPECT_GT(lung, 40);
  EXPECT_LT(lung, 120);
  EXPECT_GT(diaphragm, 2 * lung);
  EXPECT_GT(bone, 2 * diaphragm);
}

TEST_F(TouchedThorax, TouchGoesOnWhileTheBreathIsPaused) {
  load();
  Playback playback(scene, {.keys = "2:p", .touch = {.stylus = path(kOntoRib)}});
  playback.runUntil(3);
  EXPECT_EQ(touched(), "RIB_L4");
  const float before = number("STYLUS.depth");
  playback.runUntil(4);
  EXPECT_NEAR(number("STYLUS.depth"), before, 1e-4);
  EXPECT_GT(vector("STYLUS.force").norm(), 0.1f);
}

TEST_F(TouchedThorax, SomethingTouchedGoesBackToWhatItWas) {
  load();
  Playback playback(scene,
                    {.touch = {.stylus = path("0,0.15,0.03,0.12\n1,0.097,0.029,0.068\n2,0.090,0.029,0.061\n"
                                              "3,0.097,0.029,0.068\n4,0.15,0.03,0.12\n")}});
  playback.runUntil(2);
  EXPECT_EQ(touched(), "LUNG_L");
  playback.runUntil(4);
  auto& lung = dynamic_cast<DeformableShape2&>(scene.node("LUNG_L"));
  EXPECT_EQ(lung.touchedCoord.getValue(), lung.deformedCoord.getValue());
}

/// A rib that turns, as something to measure distances from.
class MovingRib {
 public:
  MovingRib(Scene& scene, const std::string& name)
      : transform_(dynamic_cast<Transform&>(scene.node(name))), surface_(surfaceOf(transform_)) {}

  /// [m] of a place in the scene, negative inside.
  double distance(const Vec3f& place) {
    const Vec3f local = (transform_.matrix.getValue().inverse() * place.homogeneous()).head<3>();
    return surface_.signedDistance(local.cast<double>());
  }

 private:
  static SurfaceQuery surfaceOf(Node& node) {
    if (auto* shape = dynamic_cast<Shape*>(&node)) {
      auto& geometry = dynamic_cast<X3DComposedGeometryNode&>(*shape->geometry.getValue());
      const auto points = dynamic_cast<Coordinate&>(*geometry.coord.getValue()).point.getValue();
      return {points, trianglesOf(geometry, points.size())};
    }
    return surfaceOf(*inside(node).front());
  }

  Transform& transform_;
  SurfaceQuery surface_;
};

/// The hand goes to and fro over left ribs 4 to 6 while they move, two millimetres deep: wherever it has
/// the ball in bone, something is felt, and the ball that is seen stays outside.
class SlidingOverRibs : public TouchedThorax, public ::testing::WithParamInterface<int> {};

TEST_P(SlidingOverRibs, NeverLosesThem) {
  load();
  std::string way = "0,0.130,0.060,0.090\n1,0.110,0.056,0.070\n2,0.0984,0.052,0.0584\n";
  for (int start = 2; start < 58; start += 8) {
    way += fmt::format("{},0.1,0.021,0.0755\n{},0.0984,-0.030,0.0894\n", start + 2, start + 4);
    way += fmt::format("{},0.1,0.021,0.0755\n{},0.0984,0.052,0.0584\n", start + 6, start + 8);
  }
  Playback playback(scene,
                    {.set = {fmt::format("BREATH.rate={}", GetParam())}, .touch = {.stylus = path(way)}});
  playback.runUntil(0);
  std::map<std::string, MovingRib> ribs;
  for (const char* name : {"RIB_L4", "RIB_L5", "RIB_L6"}) ribs.emplace(name, MovingRib(scene, name));
  constexpr double kRadius = 0.0025, kTolerance = 0.0003;
  std::map<std::string, int> deep;
  double nearest = 1;
  int losses = 0;
  playback.runUntil(60, [&](Time) {
    const Vec3f hand = vector("STYLUS.trackerPosition"), ball = vector("STYLUS.proxyPosition");
    for (auto& [name, rib] : ribs) {
      nearest = std::min(nearest, rib.distance(ball));
      if (rib.distance(hand) > kRadius - kTolerance) continue;
      ++deep[name];
      if (touched().empty()) ++losses;
    }
  });
  EXPECT_EQ(losses, 0);
  EXPECT_GT(nearest, kRadius - kTolerance);
  for (const auto& [name, rib] : ribs) EXPECT_GT(deep[name], 60) << name << ": the hand is hardly in it";
}

INSTANTIATE_TEST_SUITE_P(AtRates, SlidingOverRibs, ::testing::Values(15, 60));

/// The stylus rests on a part for a minute while the thorax breathes, held a few millimetres in: it never
/// loses it.
class RestingOn : public TouchedThorax, public ::testing::WithParamInterface<std::tuple<std::string, int>> {};

TEST_P(RestingOn, NeverLosesIt) {
  const auto& [part, rate] = GetParam();
  load();
  const std::string way = part == "LUNG_L" ? kOntoLung : part == "RIB_L4" ? kOntoRib : kOntoDiaphragm;
  Playback playback(scene, {.set = {fmt::format("BREATH.rate={}", rate)}, .touch = {.stylus = path(way)}});
  int losses = 0;
  Time lost = 0;
  float deepest = 0;
  playback.runUntil(60, [&](Time now) {
    if (now < 3.5) return;
    deepest = std::max(deepest, number("STYLUS.depth"));
    if (touched() == part && number("STYLUS.depth") > 0) return;
    ++losses;
    lost = now;
  });
  EXPECT_EQ(losses, 0) << "last at " << lost << " s";
  EXPECT_LT(deepest, 0.03f);
}

INSTANTIATE_TEST_SUITE_P(AtRates, RestingOn,
                         ::testing::Combine(::testing::Values("RIB_L4", "LUNG_L", "DIAPHRAGM"),
                                            ::testing::Values(15, 60)),
                         [](const auto& test) {
                           return std::get<0>(test.param) + "_" + std::to_string(std::get<1>(test.param));
                         });

}  // namespace
}  // namespace pleura
