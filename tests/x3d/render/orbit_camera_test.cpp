#include <limits>
#include <random>

#include "shapes.h"
#include <gtest/gtest.h>

#include <pleura/x3d/browser/render/orbit_camera.h>
#include <pleura/x3d/browser/render/projection.h>

namespace pleura::render::test {
namespace {

constexpr int width = 640, height = 480;

OrbitCamera fromFront(bool orthographic = false) {
  DrawList list;
  lookFrom(list, {0, 0, 4});
  if (orthographic) list.camera.orthographic = OrthographicExtent{};
  return {list.camera, Eigen::Vector3f::Zero()};
}

Eigen::Vector3f eye(const OrbitCamera& orbit) {
  const Eigen::Matrix4f inverse = orbit.camera().view.inverse();
  return inverse.topRightCorner<3, 1>();
}

Eigen::Vector2f pictured(const OrbitCamera& orbit, const Eigen::Vector3f& point) {
  return projectToPicture(orbit.camera(), width, height, point).value();
}

TEST(OrbitCamera, OrbitKeepsDistanceAxesAndTheCentersPlace) {
  OrbitCamera orbit = fromFront();
  std::mt19937 random(5);
  std::uniform_real_distribution<float> pixels(-300, 300);
  for (int i = 0; i < 10000; ++i) orbit.orbit(pixels(random), pixels(random), height);
  EXPECT_NEAR(eye(orbit).norm(), 4, 1e-3);
  const Eigen::Matrix3f R = orbit.camera().view.topLeftCorner<3, 3>();
  EXPECT_TRUE((R * R.transpose()).isIdentity(1e-5f));
  EXPECT_NEAR(R(0, 1), 0, 1e-3) << "+Y leans";
  EXPECT_LE((pictured(orbit, {0, 0, 0}) - Eigen::Vector2f(width / 2, height / 2)).norm(), 0.5f);
}

TEST(OrbitCamera, WhatIsUnderTheMouseFollowsIt) {
  OrbitCamera orbit = fromFront();
  const Eigen::Vector3f near(0, 0, 1);
  const Eigen::Vector2f before = pictured(orbit, near);
  orbit.orbit(20, 0, height);
  EXPECT_GT(pictured(orbit, near).x(), before.x() + 5);
  orbit.orbit(0, 20, height);
  EXPECT_GT(pictured(orbit, near).y(), before.y() + 5);
}

TEST(OrbitCamera, HalfATurnOverTheHeightAndStopsAtThePoles) {
  OrbitCamera orbit = fromFront();
  orbit.orbit(height, 0, height);
  EXPECT_LE((eye(orbit) - Eigen::Vector3f(0, 0, -4)).norm(), 1e-4f);
  orbit.orbit(0, 10 * height, height);
  EXPECT_GT(eye(orbit).y(), 3.99f);
  EXPECT_GT(orbit.camera().view(1, 1), 0) << "upside down";
}

TEST(OrbitCamera, PanMovesTheCenterByThePixelsAsked) {
  for (const bool orthographic : {false, true}) {
    OrbitCamera orbit = fromFront(orthographic);
    orbit.orbit(77, 33, height);
    const Eigen::Vector2f before = pictured(orbit, {0, 0, 0});
    orbit.pan(50, -20, width, height);
    EXPECT_LE((pictured(orbit, {0, 0, 0}) - before - Eigen::Vector2f(50, -20)).norm(), 0.05f);
    EXPECT_LE((pictured(orbit, orbit.center()) - before).norm(), 0.05f);
  }
}

TEST(OrbitCamera, ZoomComesNearerButNeverReachesTheCenter) {
  OrbitCamera orbit = fromFront();
  orbit.zoom(1);
  EXPECT_NEAR(eye(orbit).z(), 3.6, 1e-5);
  orbit.zoom(-1);
  EXPECT_NEAR(eye(orbit).z(), 4, 1e-5);
  orbit.zoom(60);
  EXPECT_GT(eye(orbit).z(), 0);
  EXPECT_LT(orbit.camera().nearDistance, eye(orbit).z());
  OrbitCamera flat = fromFront(true);
  flat.zoom(1);
  EXPECT_NEAR(flat.camera().orthographic->top, 0.9, 1e-6);
}

TEST(OrbitCamera, FitShowsTheWholeBoxFromTheSameSide) {
  const Eigen::AlignedBox3f box(Eigen::Vector3f(1, 2, 3), Eigen::Vector3f(4, 9, 5));
  for (const bool orthographic : {false, true}) {
    OrbitCamera orbit = fromFront(orthographic);
    orbit.orbit(120, 40, height);
    const Eigen::Matrix3f before = orbit.camera().view.topLeftCorner<3, 3>();
    orbit.fit(box);
    EXPECT_TRUE(before.isApprox(orbit.camera().view.topLeftCorner<3, 3>()));
    EXPECT_TRUE(orbit.center().isApprox(box.center()));
    for (int corner = 0; corner < 8; ++corner) {
      const Eigen::Vector2f p =
          pictured(orbit, box.corner(static_cast<Eigen::AlignedBox3f::CornerType>(corner)));
      EXPECT_TRUE(p.x() >= 0 && p.x() <= width && p.y() >= 0 && p.y() <= height) << p.transpose();
    }
  }
}

TEST(OrbitCamera, ResetGoesBackToTheViewpoint) {
  OrbitCamera orbit = fromFront();
  const Eigen::Matrix4f view = orbit.camera().view;
  orbit.orbit(30, 40, height);
  orbit.pan(3, 4, width, height);
  orbit.zoom(2);
  orbit.reset();
  EXPECT_EQ(orbit.camera().view, view);
  EXPECT_EQ(orbit.center(), Eigen::Vector3f(0, 0, 0));
}

TEST(OrbitCamera, BadValuesAreRefused) {
  OrbitCamera orbit = fromFront();
  EXPECT_THROW(orbit.fit(Eigen::AlignedBox3f()), std::invalid_argument);
  const float nan = std::numeric_limits<float>::quiet_NaN();
  EXPECT_THROW(OrbitCamera(Camera{}, Eigen::Vector3f(nan, 0, 0)), std::invalid_argument);
}

TEST(Projection, FieldOfViewSpansTheSmallerSide) {
  Camera camera;
  camera.fieldOfView = 1;
  const float x = std::tan(0.5f);
  EXPECT_NEAR(projectToPicture(camera, 200, 400, {x, 0, -1})->x(), 200, 1e-3);
  EXPECT_NEAR(projectToPicture(camera, 400, 200, {0, x, -1})->y(), 0, 1e-3);
  EXPECT_FALSE(projectToPicture(camera, 400, 200, {0, 0, 1}).has_value());
}

}  // namespace
}  // namespace pleura::render::test
