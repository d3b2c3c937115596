#include <random>

#include <gtest/gtest.h>

#include <pleura/nodes/thorax/motion/harmonic_fill.h>

namespace pleura {
namespace {

constexpr int kSide = 12;

/// A square sheet of kSide x kSide points, 5 mm apart.
TriangleMesh sheet() {
  TriangleMesh mesh;
  for (int y = 0; y < kSide; ++y) {
    for (int x = 0; x < kSide; ++x) {
      mesh.points.emplace_back(0.005f * static_cast<float>(x), 0.005f * static_cast<float>(y), 0.0f);
      if (x == 0 || y == 0) continue;
      const int i = y * kSide + x;
      mesh.triangles.push_back({i - kSide - 1, i - kSide, i});
      mesh.triangles.push_back({i - kSide - 1, i, i - 1});
    }
  }
  return mesh;
}

std::vector<int> border() {
  std::vector<int> points;
  for (int i = 0; i < kSide * kSide; ++i) {
    const int x = i % kSide;
    const int y = i / kSide;
    if (x == 0 || y == 0 || x == kSide - 1 || y == kSide - 1) points.push_back(i);
  }
  return points;
}

TEST(HarmonicFill, ReproducesALinearDisplacement) {
  const TriangleMesh mesh = sheet();
  HarmonicFill fill(mesh, border());
  EXPECT_EQ(fill.freeCount(), static_cast<std::size_t>((kSide - 2) * (kSide - 2)));
  const auto linear = [](const Eigen::Vector3f& p) {
    return Eigen::Vector4f(0.01f + 0.3f * p.x(), 0.2f * p.y() - 0.1f * p.x(), p.x() + p.y(), 0.0f);
  };
  std::vector<Eigen::Vector4f> displacement(mesh.points.size(), Eigen::Vector4f::Constant(9.0f));
  for (const int i : border())
    displacement[static_cast<std::size_t>(i)] = linear(mesh.points[static_cast<std::size_t>(i)]);
  fill.fill(displacement);
  for (std::size_t i = 0; i < mesh.points.size(); ++i) {
    EXPECT_LT((displacement[i] - linear(mesh.points[i])).norm(), 1e-6f);
  }
}

TEST(HarmonicFill, StaysBetweenTheSmallestAndLargestDriven) {
  std::mt19937 random(5);
  std::uniform_real_distribution<float> uniform(-0.03f, 0.07f);
  HarmonicFill fill(sheet(), border());
  std::vector<Eigen::Vector4f> displacement(std::size_t{kSide} * kSide, Eigen::Vector4f::Zero());
  for (const int i : border()) displacement[static_cast<std::size_t>(i)].setConstant(uniform(random));
  fill.fill(displacement);
  for (const Eigen::Vector4f& d : displacement) {
    EXPECT_GE(d.minCoeff(), -0.03f);
    EXPECT_LE(d.maxCoeff(), 0.07f);
  }
}

TEST(HarmonicFill, LeavesAloneWhatNothingDrives) {
  TriangleMesh mesh = sheet();
  for (const float x : {1.0f, 1.01f, 1.02f}) mesh.points.emplace_back(x, x * x, 0.0f);
  const int n = kSide * kSide;
  mesh.triangles.push_back({n, n + 1, n + 2});
  HarmonicFill fill(mesh, border());
  std::vector<Eigen::Vector4f> displacement(mesh.points.size(), Eigen::Vector4f::Constant(0.05f));
  fill.fill(displacement);
  for (std::size_t i = static_cast<std::size_t>(n); i < displacement.size(); ++i)
    EXPECT_EQ(displacement[i].norm(), 0.0f);
  EXPECT_NEAR(displacement[kSide + 1].x(), 0.05f, 1e-6f);
}

TEST(HarmonicFill, AllDrivenOrNoneIsFine) {
  const TriangleMesh mesh = sheet();
  std::vector<int> all(mesh.points.size());
  for (std::size_t i = 0; i < all.size(); ++i) all[i] = static_cast<int>(i);
  std::vector<Eigen::Vector4f> displacement(mesh.points.size(), Eigen::Vector4f::Constant(0.02f));
  const std::vector<Eigen::Vector4f> before = displacement;
  HarmonicFill(mesh, all).fill(displacement);
  EXPECT_EQ(displacement, before);
  HarmonicFill(mesh, {}).fill(displacement);
  for (const Eigen::Vector4f& d : displacement) EXPECT_EQ(d.norm(), 0.0f);
}

TEST(HarmonicFill, RefusesIndicesOutOfRange) {
  TriangleMesh mesh = sheet();
  const std::vector<int> outside{kSide * kSide};
  EXPECT_THROW(HarmonicFill(mesh, outside), std::invalid_argument);
  mesh.triangles.push_back({0, 1, -1});
  EXPECT_THROW(HarmonicFill(mesh, border()), std::invalid_argument);
}

}  // namespace
}  // namespace pleura
