#include <limits>
#include <vector>

#include "shapes.h"
#include <gtest/gtest.h>

#include <pleura/nodes/deformable/mesh/measures.h>

namespace pleura {
namespace {

using Eigen::Vector3d;
using Eigen::Vector3f;

double volume(const TriangleMesh& mesh) { return signedVolume(mesh.points, mesh.triangles); }

TEST(SignedVolume, IsOneForTheUnitCubeAndMinusOneInsideOut) {
  EXPECT_DOUBLE_EQ(volume(shapes::cube()), 1);
  EXPECT_DOUBLE_EQ(volume(shapes::flipped(shapes::cube())), -1);
  EXPECT_EQ(volume({}), 0);
}

TEST(SignedVolume, LosesNothingFarFromTheOrigin) {
  TriangleMesh mesh = shapes::sphere(32);
  for (Vector3f& point : mesh.points)
    point = (point * 8192).array().round() / 8192;  // so that moving is exact
  const double before = volume(mesh);
  for (Vector3f& point : mesh.points) point += Vector3f(1000, -1000, 500);
  EXPECT_NEAR(volume(mesh), before, 1e-14 * before);
}

TEST(SignedVolume, ConvergesToTheTorusInSecondOrder) {
  const double exact = 2 * std::numbers::pi * std::numbers::pi * 0.16;
  const double coarse = exact - volume(shapes::torus(40, 20)), fine = exact - volume(shapes::torus(80, 40));
  EXPECT_GT(fine, 0);
  EXPECT_NEAR(coarse / fine, 4, 0.1);
}

TEST(SurfaceArea, IsSixForTheCubeAndTellsTheSphere) {
  const TriangleMesh cube = shapes::cube(), sphere = shapes::sphere(64);
  EXPECT_DOUBLE_EQ(surfaceArea(cube.points, cube.triangles), 6);
  EXPECT_NEAR(surfaceArea(sphere.points, sphere.triangles), 4 * std::numbers::pi, 0.03);
}

TEST(BoundingBox, HoldsThePointsTightly) {
  const auto box = boundingBox(shapes::torus(40, 20).points);
  EXPECT_NEAR(box.max().x(), 1.4f, 1e-6f);
  EXPECT_NEAR(box.min().z(), -0.4f, 1e-6f);
  EXPECT_TRUE(boundingBox({}).isEmpty());
}

TEST(VertexNormals, DoNotDependOnHowACubeIsTriangulated) {
  const TriangleMesh mesh = shapes::cube();
  std::vector<Vector3f> normals(mesh.points.size());
  vertexNormals(mesh.points, mesh.triangles, normals);
  for (std::size_t i = 0; i < normals.size(); ++i) {
    const Vector3f outwards = (mesh.points[i] - Vector3f::Constant(0.5f)).normalized();
    EXPECT_LT((normals[i] - outwards).norm(), 1e-6f);
  }
}

TEST(VertexNormals, AreZeroWhereThereIsNoArea) {
  const std::vector<Vector3f> points = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {2, 0, 0}, {5, 5, 5}};
  const std::vector<Eigen::Vector3i> triangles = {{0, 1, 2}, {1, 2, 3}, {2, 2, 3}};
  std::vector<Vector3f> normals(points.size(), Vector3f::Ones());
  vertexNormals(points, triangles, normals);
  for (const Vector3f& normal : normals) EXPECT_EQ(normal, Vector3f::Zero());
  normals.pop_back();
  EXPECT_THROW(vertexNormals(points, triangles, normals), std::invalid_argument);
}

TEST(WindingNumber, CountsClosedSurfacesAndSharesOutOpenOnes) {
  TriangleMesh mesh = shapes::cube();
  EXPECT_NEAR(windingNumber(mesh.points, mesh.triangles, {0.5, 0.4, 0.3}), 1, 1e-12);
  EXPECT_NEAR(windingNumber(mesh.points, mesh.triangles, {0.5, 0.4, 1.3}), 0, 1e-12);
  mesh.triangles.resize(10);  // without x = 1
  EXPECT_NEAR(windingNumber(mesh.points, mesh.triangles, {0.5, 0.5, 0.5}), 5.0 / 6, 1e-12);
}

TEST(RequireFinite, NamesTheFirstBadPoint) {
  std::vector<Vector3f> points(4, Vector3f::Zero());
  EXPECT_NO_THROW(requireFinite(points));
  points[2].y() = std::numeric_limits<float>::quiet_NaN();
  try {
    requireFinite(points);
    FAIL();
  } catch (const std::invalid_argument& error) {
    EXPECT_STREQ(error.what(), "points: point 2 is not finite");
  }
}

}  // namespace
}  // namespace pleura
