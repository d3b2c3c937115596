#include <random>

#include "ring_cage.h"
#include <gtest/gtest.h>

#include <pleura/nodes/thorax/motion/wall_binding.h>

namespace pleura {
namespace {

/// Fold and rim at fixed rows; the fold drops by eight of them.
WallSlide slideByRows() {
  const std::size_t n = PleuralWall::kColumns;
  return {std::vector<double>(n, 30.0), std::vector<double>(n, 45.0), std::vector<double>(n, 8.0)};
}

/// Points 2-6 mm inside the wall, between its rings.
std::vector<Eigen::Vector3d> pointsInside() {
  std::mt19937 random(2);
  std::uniform_real_distribution<double> angle(-3.1, 3.1);
  std::uniform_real_distribution<double> height(-0.06, 0.06);
  std::uniform_real_distribution<double> radius(0.089, 0.093);
  std::vector<Eigen::Vector3d> points;
  for (int k = 0; k < 100; ++k) {
    const double a = angle(random);
    const double r = radius(random);
    points.emplace_back(r * std::cos(a), height(random), r * std::sin(a));
  }
  return points;
}

TEST(WallBinding, FindsGapAndPlace) {
  const RingCage cage;
  for (const Eigen::Vector3d& p : pointsInside()) {
    const WallPoint place = bindToWall(cage.wall, slideByRows(), p);
    ASSERT_TRUE(place.bound);
    EXPECT_FALSE(place.onSpine);
    EXPECT_NEAR(place.gap, 0.0955 - std::hypot(p.x(), p.z()), 0.0015);
    EXPECT_NEAR(place.distance, place.gap, 0.0005);
    EXPECT_LT((place.rest.head<3>().cast<double>() - p).norm(), 0.0015);
  }
}

TEST(WallBinding, RestsBitForBit) {
  const RingCage cage;
  for (const Eigen::Vector3d& p : pointsInside()) {
    const WallPoint place = bindToWall(cage.wall, slideByRows(), p);
    EXPECT_EQ(followWall(cage.wall, cage.wall.rest, slideByRows(), place, 0.0), place.rest);
  }
}

TEST(WallBinding, FollowsTheMovedWallAndSlidesDownIt) {
  const RingCage cage;
  std::vector<Eigen::Vector4f> now = cage.wall.rest;
  moveWall(cage.wall, RingCage::lifted(0.01f), now);
  for (const Eigen::Vector3d& p : pointsInside()) {
    const WallPoint place = bindToWall(cage.wall, slideByRows(), p);
    const Eigen::Vector4f carried = followWall(cage.wall, now, slideByRows(), place, 0.0);
    EXPECT_LT((carried - place.rest - Eigen::Vector4f(0.0f, 0.01f, 0.0f, 0.0f)).norm(), 1e-5f);
    const Eigen::Vector4f slid = followWall(cage.wall, cage.wall.rest, slideByRows(), place, 1.0);
    if (place.v < 1.9f) {
      EXPECT_LT(slid.y(), place.rest.y());
    }
    EXPECT_NEAR(std::hypot(slid.x(), slid.z()), std::hypot(place.rest.x(), place.rest.z()), 0.003f);
  }
}

TEST(WallBinding, LiftsWhatLiesTooNearWhileItSlides) {
  const RingCage cage;
  const auto bound = [&](double radius) {
    return bindToWall(cage.wall, slideByRows(), {radius, 0.015, 0.0});
  };
  EXPECT_NEAR(bound(0.096).gap + bound(0.096).lift, 0.001, 1e-6);
  EXPECT_EQ(bound(0.0925).lift, 0.0f);
  // How much of the lift has come.
  const auto lifted = [&](double contraction) {
    const WallPoint place = bound(0.096);
    WallPoint stays = place;
    stays.lift = 0.0f;
    const auto at = [&](const WallPoint& p) {
      return followWall(cage.wall, cage.wall.rest, slideByRows(), p, contraction);
    };
    return (at(place) - at(stays)).norm() / place.lift;
  };
  EXPECT_EQ(lifted(0.0), 0.0f);
  EXPECT_GT(lifted(0.3), 0.5f);   // soon
  EXPECT_GT(lifted(-0.3), 0.5f);  // whichever way it slides
  EXPECT_GT(lifted(1.0), 0.9f);
  EXPECT_LT(lifted(1.0), 1.001f);
}

TEST(WallBinding, AdvancesDownTheWallWithContraction) {
  const RingCage cage;
  WallPoint place = bindToWall(cage.wall, slideByRows(), {0.094, 0.015, 0.0});
  const auto height = [&](double contraction) {
    return followWall(cage.wall, cage.wall.rest, slideByRows(), place, contraction).y();
  };
  const float before = height(1.0);
  place.advance = 0.1f;
  EXPECT_EQ(height(0.0), place.rest.y());
  EXPECT_LT(height(1.0), before - 0.002f);
}

}  // namespace
}  // namespace pleura
