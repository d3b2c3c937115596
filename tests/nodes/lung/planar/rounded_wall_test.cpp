#include <random>

#include <gtest/gtest.h>

#include <pleura/nodes/lung/planar/rounded_wall.h>

namespace pleura::planar {
namespace {

using Eigen::Matrix4d;
using Eigen::Vector2d;
using Eigen::Vector4d;

constexpr double kReach = 0.01;  // [m]

WallGap gapAt(RoundedWall& wall, const Vector4d& z) {
  wall.move(z.tail<2>());
  return wall.gapAt(z.head<2>(), kReach);
}

TEST(RoundedWall, DerivativesAreThoseOfTheGap) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> some(-1, 1);
  for (const bool isMirrored : {false, true}) {
    const ChestOutline outline = makeHemithorax({.isMirrored = isMirrored}).wall;
    RoundedWall wall(outline);
    int checked = 0;
    for (std::size_t k = 0; k < outline.rest.size(); ++k) {
      const std::size_t next = (k + 1) % outline.rest.size();
      const Vector2d along = outline.rest[next] - outline.rest[k];
      const Vector2d inwards = outline.orientation * Vector2d(-along.y(), along.x()).normalized();
      const Vector2d q(0.01 * some(random), 0.01 * some(random));
      Vector4d z;
      z << outline.at(k, q) + (0.5 + 0.5 * some(random)) * along + 0.0008 * inwards, q;
      const WallGap at = gapAt(wall, z);
      if (!at.isNear || at.gap < 1e-4 || std::abs(at.bend) > 300) continue;  // sharp corner
      ++checked;
      const Matrix4d curvature = at.curvature();
      for (int i = 0; i < 4; ++i) {
        const double step = 1e-6;
        const WallGap more = gapAt(wall, z + step * Vector4d::Unit(i));
        const WallGap less = gapAt(wall, z - step * Vector4d::Unit(i));
        EXPECT_NEAR((more.gap - less.gap) / (2 * step), at.gradient[i], 1e-6);
        if (!more.isNear || !less.isNear || std::abs(more.bend - less.bend) > 1) continue;  // another piece
        const Vector4d column = (more.gradient - less.gradient) / (2 * step);
        EXPECT_NEAR((column - curvature.col(i)).norm(), 0, 1e-4 * (1 + curvature.norm())) << k << " " << i;
      }
    }
    EXPECT_GT(checked, 40);
  }
}

TEST(RoundedWall, InsideIsPositiveNearAndFar) {
  for (const bool isMirrored : {false, true}) {
    const Hemithorax half = makeHemithorax({.isMirrored = isMirrored});
    const RoundedWall wall(half.wall);
    for (const Vector2d& p : half.lung.points) EXPECT_GT(wall.gapAt(p, kReach).gap, 0);
    const Vector2d middle = half.lung.points.back();
    for (const Vector2d& w : half.wall.rest)
      for (const double far : {1.05, 1.5, 100.0})
        EXPECT_LT(wall.gapAt(middle + far * (w - middle), 1e-3).gap, 0);
  }
}

TEST(RoundedWall, APointSlidesOverItsCornersWithoutAJump) {
  const ChestOutline outline = makeHemithorax({}).wall;
  const RoundedWall wall(outline);
  Vector2d last = Vector2d::Zero();
  const std::size_t lateral = outline.rest.size() / 2;
  for (int i = 0; i <= 4000; ++i) {
    const double along = i / 1000.0;
    const auto k = lateral + static_cast<std::size_t>(i / 1000);
    const Vector2d p = outline.rest[k] + (along - i / 1000) * (outline.rest[k + 1] - outline.rest[k]);
    const WallGap at = wall.gapAt(p - Vector2d(0.002, 0), kReach);
    ASSERT_TRUE(at.isNear);
    EXPECT_LT(i > 0 ? (at.gradient.head<2>() - last).norm() : 0, 0.001);
    last = at.gradient.head<2>();
  }
}

}  // namespace
}  // namespace pleura::planar
