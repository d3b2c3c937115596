#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "shapes.h"
#include <gtest/gtest.h>

#include <pleura/nodes/deformable/mesh/measures.h>
#include <pleura/nodes/deformable/mesh/surface_query.h>
#include <pleura/nodes/deformable/mesh/triangle_geometry.h>

namespace pleura {
namespace {

using Eigen::Vector3d;
using Eigen::Vector3f;
using Eigen::Vector3i;

constexpr double inf = std::numeric_limits<double>::infinity();

SurfaceQuery queryOf(const TriangleMesh& mesh) { return {mesh.points, mesh.triangles}; }

Corners cornersOf(const SurfaceQuery& surface, int triangle) {
  const Vector3i& t = surface.triangles()[triangle];
  Corners corners;
  for (int k = 0; k < 3; ++k) corners.col(k) = surface.points()[t[k]].cast<double>();
  return corners;
}

double closestByTryingAll(const SurfaceQuery& surface, const Vector3d& p) {
  double least = inf;
  for (std::size_t t = 0; t < surface.triangles().size(); ++t)
    least =
        std::min(least, closestPointOnTriangle(cornersOf(surface, static_cast<int>(t)), p).squaredDistance);
  return std::sqrt(least);
}

double firstHitByTryingAll(const SurfaceQuery& surface, const Ray& ray) {
  double first = inf;
  for (std::size_t t = 0; t < surface.triangles().size(); ++t) {
    const auto hit = ray.meet(cornersOf(surface, static_cast<int>(t)));
    if (hit && hit->t >= 0) first = std::min(first, hit->t);
  }
  return first;
}

void expectSameAsTryingAll(const SurfaceQuery& surface, std::mt19937& random, int queries) {
  for (int i = 0; i < queries; ++i) {
    const Vector3d p = shapes::randomPoint(random, 2), direction = shapes::randomPoint(random);
    const SurfacePoint nearest = surface.closestPoint(p);
    EXPECT_EQ(nearest.distance, closestByTryingAll(surface, p));
    EXPECT_NEAR((nearest.point - p).norm(), nearest.distance, 1e-12);
    const auto hit = surface.intersectRay(p, direction);
    EXPECT_EQ(hit ? hit->distance : inf, firstHitByTryingAll(surface, Ray(p, direction)));
  }
}

TEST(SurfaceQuery, FindsWhatTryingEveryTriangleFinds) {
  std::mt19937 random(1);
  for (const int triangles : {1, 2, 3, 4, 5, 9, 33, 500}) {
    SCOPED_TRACE(triangles);
    expectSameAsTryingAll(queryOf(shapes::soup(triangles, random)), random, 100);
  }
  expectSameAsTryingAll(queryOf(shapes::torus(40, 20)), random, 300);
}

TEST(SurfaceQuery, FindsItAfterRefitToo) {
  std::mt19937 random(2);
  const TriangleMesh mesh = shapes::torus(40, 20);
  SurfaceQuery surface = queryOf(mesh);
  std::vector<Vector3f> moved = mesh.points;
  for (Vector3f& point : moved) point = Vector3f(point.y() * 0.5f, point.z(), point.x() + 0.3f * point.y());
  surface.refit(moved);
  expectSameAsTryingAll(surface, random, 300);
  surface.refit(mesh.points);
  EXPECT_EQ(surface.closestPoint({0.3, 0.2, 0.1}).point, queryOf(mesh).closestPoint({0.3, 0.2, 0.1}).point);
}

TEST(SurfaceQuery, BearsTrianglesWithoutArea) {
  std::mt19937 random(3);
  TriangleMesh mesh = shapes::soup(40, random);
  for (std::size_t t = 0; t < mesh.triangles.size(); t += 2) mesh.triangles[t][2] = mesh.triangles[t][1];
  for (std::size_t i = 0; i < 30; ++i) mesh.points[i] = Vector3f(0.5f, 0.5f, 0.5f);
  expectSameAsTryingAll(queryOf(mesh), random, 200);
}

TEST(SurfaceQuery, SignAgreesWithTheWindingNumber) {
  std::mt19937 random(4);
  // a torus of thin tube has creases, saddles and both hull and hole; few facets make them sharp
  for (const TriangleMesh& mesh :
       {shapes::cube(), shapes::sphere(6), shapes::torus(5, 3), shapes::torus(30, 12)}) {
    const SurfaceQuery surface = queryOf(mesh);
    for (int i = 0; i < 500; ++i) {
      const Vector3d p = shapes::randomPoint(random, 1.5);
      const bool inside = windingNumber(mesh.points, mesh.triangles, p) > 0.5;
      EXPECT_EQ(surface.isInside(p), inside) << p.transpose();
      EXPECT_EQ(std::abs(surface.signedDistance(p)), surface.closestPoint(p).distance);
    }
  }
}

TEST(SurfaceQuery, SignHoldsAtSpikesWhereFaceNormalsMislead) {
  // a needle: from points beyond its tip most of its faces look as if seen from behind
  const std::vector<Vector3f> points = {{0, 0, 10}, {1, 0, 0}, {-0.5f, 0.8f, 0}, {-0.5f, -0.8f, 0}};
  const std::vector<Vector3i> triangles = {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {1, 3, 2}};
  const SurfaceQuery surface(points, triangles);
  std::mt19937 random(5);
  for (int i = 0; i < 500; ++i) {
    const Vector3d p = Vector3d(0, 0, 10) + shapes::randomPoint(random, 0.5);
    EXPECT_EQ(surface.isInside(p), windingNumber(points, triangles, p) > 0.5) << p.transpose();
  }
}

TEST(SurfaceQuery, PseudonormalOfACubeIsTheFeaturesOwn) {
  const SurfaceQuery surface = queryOf(shapes::cube());
  const auto normalAt = [&surface](const Vector3d& p) {
    return Vector3d(surface.pseudonormal(surface.closestPoint(p)).normalized());
  };
  EXPECT_LT((normalAt({2, 2, 2}) - Vector3d::Ones().normalized()).norm(), 1e-12);
  EXPECT_LT((normalAt({2, 2, 0.3}) - Vector3d(1, 1, 0).normalized()).norm(), 1e-12);
  EXPECT_LT((normalAt({2, 0.5, 0.5}) - Vector3d(1, 0, 0)).norm(), 1e-12);  // on a diagonal
}

TEST(SurfaceQuery, WithinLooksNoFartherThanAsked) {
  const SurfaceQuery surface = queryOf(shapes::cube());
  EXPECT_FALSE(surface.closestPointWithin({0.5, 0.5, 2}, 1.0));
  EXPECT_TRUE(surface.closestPointWithin({0.5, 0.5, 2}, 1.0001));
  EXPECT_THROW(surface.closestPointWithin({0.5, 0.5, 2}, -1), std::invalid_argument);
  EXPECT_THROW(surface.closestPointWithin({0.5, 0.5, 2}, std::nan("")), std::invalid_argument);
}

TEST(SurfaceQuery, RaysDoNotSlipThroughEdgesAndCorners) {
  const TriangleMesh mesh = shapes::sphere(24);
  const SurfaceQuery surface = queryOf(mesh);
  for (const Vector3i& triangle : mesh.triangles) {
    for (int k = 0; k < 3; ++k) {
      const Vector3d corner = mesh.points[triangle[k]].cast<double>();
      const Vector3d middle = (corner + mesh.points[triangle[(k + 1) % 3]].cast<double>()) / 2;
      EXPECT_TRUE(surface.intersectRay({0.01, 0.02, 0.03}, corner - Vector3d(0.01, 0.02, 0.03)));
      EXPECT_TRUE(surface.intersectRay({0.01, 0.02, 0.03}, middle - Vector3d(0.01, 0.02, 0.03)));
      EXPECT_TRUE(surface.intersectRay(Vector3d::Zero(), middle));
    }
  }
}

TEST(SurfaceQuery, RaysEndAtMaxTAndRunAlongAxes) {
  const SurfaceQuery surface = queryOf(shapes::cube());
  EXPECT_NEAR(surface.intersectRay({0.3, 0.2, -1}, {0, 0, 1})->distance, 1, 1e-15);
  EXPECT_NEAR(surface.intersectRay({0.3, 0.2, -1}, {0, 0, 4}, 0.2501)->distance, 0.25, 1e-15);
  EXPECT_FALSE(surface.intersectRay({0.3, 0.2, -1}, {0, 0, 4}, 0.2499));
  EXPECT_FALSE(surface.intersectRay({1.3, 0.2, -1}, {0, 0, 1}));
  EXPECT_FALSE(surface.intersectRay({0.3, 0.2, -1}, {0, 0, -1}));
}

TEST(SurfaceQuery, ADistanceMayBeAsLargeAsFloatsAllow) {
  const float far = std::numeric_limits<float>::max();
  const std::vector<Vector3f> points = {{-far, -far, -far}, {far, -far, -far}, {-far, far, -far}};
  const SurfaceQuery surface(points, std::vector<Vector3i>{{0, 1, 2}});
  EXPECT_GT(surface.closestPoint(Vector3d::Constant(far)).distance, far);
}

TEST(SurfaceQuery, RefusesBadInputAndKeepsTheLastGoodSurface) {
  const TriangleMesh mesh = shapes::cube();
  SurfaceQuery surface = queryOf(mesh);
  std::vector<Vector3f> bad = mesh.points;
  bad[3].x() = std::numeric_limits<float>::infinity();
  EXPECT_THROW(surface.refit(bad), std::invalid_argument);
  EXPECT_THROW(SurfaceQuery(bad, mesh.triangles), std::invalid_argument);
  EXPECT_THROW(surface.refit(std::span(mesh.points).first(7)), std::invalid_argument);
  EXPECT_THROW(SurfaceQuery(mesh.points, {}), std::invalid_argument);
  EXPECT_THROW(SurfaceQuery(mesh.points, std::vector<Vector3i>{{0, 1, 8}}), std::invalid_argument);
  EXPECT_THROW(surface.closestPoint({std::nan(""), 0, 0}), std::invalid_argument);
  EXPECT_THROW(surface.closestPoint({inf, 0, 0}), std::invalid_argument);
  EXPECT_THROW(surface.intersectRay({0, 0, 0}, {0, 0, 0}), std::invalid_argument);
  EXPECT_THROW(surface.intersectRay({0, inf, 0}, {0, 1, 0}), std::invalid_argument);
  EXPECT_THROW(surface.intersectRay({0, 0, 0}, {0, 1, 0}, -1), std::invalid_argument);
  EXPECT_EQ(surface.signedDistance({0.5, 0.5, 2}), 1);
}

}  // namespace
}  // namespace pleura
