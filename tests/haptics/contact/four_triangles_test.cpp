#include "surfaces.h"
#include <gtest/gtest.h>

#include <pleura/haptics/contact/four_triangles.h>

namespace pleura::haptics {
namespace {

using Eigen::Vector3d;

/// Triangles of 1 um to 1 m at places up to 1 m away, and a number for each.
template <class Visit>
void visitRandomFours(Visit visit) {
  std::mt19937 random(1);
  for (int i = 0; i < 4000; ++i) {
    FourTriangles four;
    std::array<Corners, 4> corners;
    for (int k = 0; k < 4; ++k) {
      const Vector3d place = surfaces::randomPoint(random, std::pow(10.0, -(i % 4)));
      for (int c = 0; c < 3; ++c)
        corners[k].col(c) = place + surfaces::randomPoint(random, std::pow(10.0, -(i % 7)));
      four.set(k, corners[k]);
    }
    four.bound();
    visit(four, corners, surfaces::randomPoint(random, 1));
  }
}

/// What just reaches into a ball is not said to be farther; what is clearly farther is.
TEST(FourTriangles, TellsTheFarther) {
  visitRandomFours([](const FourTriangles& four, const std::array<Corners, 4>& corners, const Vector3d& p) {
    for (int k = 0; k < 4; ++k) {
      const Vector3d low = corners[k].rowwise().minCoeff(), high = corners[k].rowwise().maxCoeff();
      const double distance = (p - p.cwiseMax(low).cwiseMin(high)).norm();
      EXPECT_LE(four.isFarther({p, distance + 1e-9})[k], 0);
      if (distance > 1e-3) {
        EXPECT_GT(four.isFarther({p, distance - 1e-5})[k], 0);
      }
    }
  });
}

/// What just sticks out of a half-space is not said to be behind; what clearly is behind is.
TEST(FourTriangles, TellsThoseBehind) {
  visitRandomFours([](const FourTriangles& four, const std::array<Corners, 4>& corners, const Vector3d& p) {
    const Vector3d normal = p.normalized();
    for (int k = 0; k < 4; ++k) {
      const double highest = (normal.transpose() * corners[k]).maxCoeff();
      EXPECT_LE(four.isBehind({normal, highest - 1e-9})[k], 0);
      EXPECT_GT(four.isBehind({normal, highest + 1e-5})[k], 0);
    }
  });
}

}  // namespace
}  // namespace pleura::haptics
