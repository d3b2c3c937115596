#include <limits>
#include <set>
#include <stdexcept>

#include "surfaces.h"
#include <gtest/gtest.h>

#include <pleura/haptics/contact/touch_shape.h>

namespace pleura::haptics {
namespace {

using Eigen::Vector3d;
using Eigen::Vector3f;
using Eigen::Vector3i;
using surfaces::Surface;
using surfaces::Touchable;

constexpr float nan = std::numeric_limits<float>::quiet_NaN();
constexpr float infinity = std::numeric_limits<float>::infinity();

TEST(TouchMesh, RefusesWhatIsNoSurface) {
  const Surface good = surfaces::box({1, 1, 1});
  const auto make = [](const Surface& s) { return TouchMesh(s.points, s.triangles); };
  EXPECT_NO_THROW(make(good));
  EXPECT_THROW(make({good.points, {}}), std::invalid_argument);
  EXPECT_THROW(make({good.points, {Vector3i(0, 0, 1)}}), std::invalid_argument);
  for (const int bad : {-1, static_cast<int>(good.points.size())}) {
    Surface surface = good;
    surface.triangles[3][1] = bad;
    EXPECT_THROW(make(surface), std::invalid_argument);
  }
  for (const float bad : {nan, infinity, -infinity}) {
    Surface surface = good;
    surface.points[5][2] = bad;
    EXPECT_THROW(make(surface), std::invalid_argument);
  }
}

TEST(TouchMesh, TellsWhetherItIsClosed) {
  const auto isClosed = [](const Surface& s) { return TouchMesh(s.points, s.triangles).isClosed(); };
  EXPECT_TRUE(isClosed(surfaces::sphere(8, 6, 1)));
  EXPECT_TRUE(isClosed(surfaces::box({1, 2, 3}, 4)));  // its sides share no points
  Surface hole = surfaces::sphere(8, 6, 1);
  hole.triangles.pop_back();
  EXPECT_FALSE(isClosed(hole));
  EXPECT_FALSE(isClosed(surfaces::sheet(1, 3, [](double, double) { return 0; })));
}

TEST(TouchMeshFrame, RefusesPointsAndStaysAsItIs) {
  const Surface surface = surfaces::box({1, 1, 1});
  const TouchMesh mesh(surface.points, surface.triangles);
  TouchMeshFrame frame;
  frame.fit(mesh, surface.points);
  const std::uint64_t serial = frame.serial;
  std::vector<Vector3f> moved = surface.points;
  for (Vector3f& p : moved) p *= 2;
  moved.back()[0] = nan;
  EXPECT_THROW(frame.fit(mesh, moved), std::invalid_argument);
  moved.pop_back();
  EXPECT_THROW(frame.fit(mesh, moved), std::invalid_argument);
  const auto isAt = [](const Eigen::Array4f& p, const Vector3f& q) { return p.head<3>().matrix() == q; };
  EXPECT_TRUE(std::ranges::equal(frame.points, surface.points, isAt));
  EXPECT_EQ(frame.serial, serial);
}

/// Every triangle nearer than the half side is visited, none twice, however the surface has moved.
TEST(TouchShape, VisitsWhatIsNear) {
  std::mt19937 random(1);
  for (const int size : {1, 2, 3, 7, 20}) {
    const Surface surface = surfaces::box({1, 0.7, 0.4}, size);
    Touchable touchable(surface);
    std::vector<Vector3f> moved = surface.points;
    for (Vector3f& p : moved) p += surfaces::randomPoint(random, 0.2).cast<float>();
    touchable.goTo(moved);
    touchable.shape.pose =
        Eigen::Translation3d(10, -20, 5) * Eigen::AngleAxisd(1, Vector3d(1, 2, 3).normalized());
    for (int i = 0; i < 200; ++i) {
      touchable.shape.s = static_cast<float>(i) / 199;
      const Vector3d p = touchable.shape.pose * surfaces::randomPoint(random, 1.5);
      const double half = std::abs(surfaces::randomPoint(random, 1)[0]);
      std::set<int> visited;
      visitNear(touchable.shape, p, half, [&](int t) {
        EXPECT_TRUE(visited.insert(t).second);
        return true;
      });
      for (int t = 0; t < static_cast<int>(surface.triangles.size()); ++t)
        if ((nearestOnTriangle(cornersOf(touchable.shape, t), p).point - p).norm() < half) {
          EXPECT_EQ(visited.count(t), 1U) << t;
        }
    }
  }
}

TEST(TouchShape, OutwardIsRightOnFacesEdgesAndCorners) {
  std::mt19937 random(2);
  const Touchable box(surfaces::box({1, 0.7, 0.4}, 3));
  for (int i = 0; i < 1000; ++i) {
    const Vector3d p = surfaces::randomPoint(random, 1.5);
    int nearest = -1;
    TrianglePoint at;
    double least = 1e30;
    for (int t = 0; t < static_cast<int>(box.mesh.triangles().size()); ++t) {
      const TrianglePoint on = nearestOnTriangle(cornersOf(box.shape, t), p);
      if ((on.point - p).norm() >= least) continue;
      least = (on.point - p).norm();
      at = on;
      nearest = t;
    }
    const bool outside = (p.cwiseAbs() - Vector3d(1, 0.7, 0.4)).maxCoeff() > 0;
    EXPECT_EQ(outward(box.shape, nearest, at.weights).dot(p - at.point) > 0, outside) << p.transpose();
  }
}

}  // namespace
}  // namespace pleura::haptics
