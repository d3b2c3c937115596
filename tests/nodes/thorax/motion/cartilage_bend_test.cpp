#include <array>
#include <cmath>

#include <gtest/gtest.h>

#include <pleura/nodes/thorax/motion/cartilage_bend.h>

namespace pleura {
namespace {

/// A straight tube of radius 6 mm along x, 60 mm long; body 0 is the rib, body 1 the sternum.
constexpr float kLength = 0.06f;
constexpr float kRadius = 0.006f;
constexpr int kRings = 13;
constexpr int kSides = 12;

std::vector<Eigen::Vector3f> centreline() {
  std::vector<Eigen::Vector3f> line;
  for (int k = 0; k < kRings; ++k)
    line.emplace_back(kLength * static_cast<float>(k) / (kRings - 1), 0.0f, 0.0f);
  return line;
}

std::vector<Eigen::Vector3f> tube() {
  std::vector<Eigen::Vector3f> points;
  for (const Eigen::Vector3f& centre : centreline()) {
    for (int k = 0; k < kSides; ++k) {
      const float angle = 6.2831853f * static_cast<float>(k) / kSides;
      points.push_back(centre + kRadius * Eigen::Vector3f(0.0f, std::cos(angle), std::sin(angle)));
    }
  }
  return points;
}

/// A rib that turns by 18 degrees about a far head, and a sternum that tilts and rises.
std::array<Eigen::Isometry3d, 2> motions() {
  std::array<Eigen::Isometry3d, 2> m;
  m[0] = Eigen::Translation3d(-0.05, 0.0, -0.1) * Eigen::AngleAxisd(0.31, Eigen::Vector3d::UnitZ()) *
         Eigen::Translation3d(0.05, 0.0, 0.1);
  m[1] = Eigen::Translation3d(0.0, 0.02, 0.015) * Eigen::AngleAxisd(-0.15, Eigen::Vector3d::UnitX());
  return m;
}

std::vector<Eigen::Vector3f> bent() {
  const auto m = motions();
  const std::array<BodyDisplacement, 2> displacements{displacementOf(m[0]), displacementOf(m[1])};
  const std::vector<BodyWeights> weights = bendCartilage(tube(), centreline(), rigidWith(0), rigidWith(1));
  std::vector<Eigen::Vector3f> now(weights.size());
  carryAll(tube(), weights, displacements, now);
  return now;
}

TEST(CartilageBend, StaysRigidlyAttachedAtBothEnds) {
  const auto rest = tube();
  const auto now = bent();
  for (std::size_t k = 0; k < kSides; ++k) {
    const std::size_t last = rest.size() - kSides + k;
    EXPECT_LT((now[k].cast<double>() - motions()[0] * rest[k].cast<double>()).norm(), 1e-6);
    EXPECT_LT((now[last].cast<double>() - motions()[1] * rest[last].cast<double>()).norm(), 1e-6);
  }
}

TEST(CartilageBend, KeepsItsThickness) {
  const auto now = bent();
  for (std::size_t ring = 0; ring < kRings; ++ring) {
    for (std::size_t k = 0; k < kSides / 2; ++k) {
      const float width = (now[ring * kSides + k] - now[ring * kSides + k + kSides / 2]).norm();
      EXPECT_GT(width, 0.95f * 2.0f * kRadius);
      EXPECT_LT(width, 1.05f * 2.0f * kRadius);
    }
  }
}

TEST(CartilageBend, LeavesAndArrivesWithoutAKink) {
  constexpr double h = 1e-5;
  EXPECT_DOUBLE_EQ(cartilageBlend(0.0), 0.0);
  EXPECT_DOUBLE_EQ(cartilageBlend(1.0), 1.0);
  EXPECT_NEAR(cartilageBlend(h) / h, 0.0, 1e-4);
  EXPECT_NEAR((1.0 - cartilageBlend(1.0 - h)) / h, 0.0, 1e-4);
  for (double t = 0.05; t < 1.0; t += 0.05) EXPECT_GT(cartilageBlend(t), cartilageBlend(t - 0.05));
}

TEST(CartilageBend, MeasuresFractionsAlongABentLine) {
  const std::vector<Eigen::Vector3f> corner{{0, 0, 0}, {3, 0, 0}, {3, 1, 0}};
  EXPECT_NEAR(fractionAlong(corner, {1.0f, -0.5f, 0.2f}), 0.25, 1e-6);
  EXPECT_NEAR(fractionAlong(corner, {3.4f, 0.5f, 0.0f}), 0.875, 1e-6);
  EXPECT_EQ(fractionAlong(corner, {-1.0f, 0.0f, 0.0f}), 0.0);
  EXPECT_EQ(fractionAlong(corner, {3.0f, 9.0f, 0.0f}), 1.0);
  EXPECT_THROW(fractionAlong({corner.data(), 1}, corner[0]), std::invalid_argument);
}

}  // namespace
}  // namespace pleura
