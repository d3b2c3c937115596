#include <limits>

#include "bodies.h"
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <pleura/nodes/deformable/fem/closed_surface.h>
#include <pleura/nodes/deformable/mesh/edge_uses.h>

namespace pleura {
namespace {

using Eigen::Vector3d;
using Eigen::Vector3f;
using testing::HasSubstr;

ClosedSurface closed(const TriangleMesh& mesh) { return closeSurface(mesh.points, mesh.triangles); }

void expectCycle(const ClosedSurface& surface) {
  forEachEdge(edgeUses(surface.mesh.triangles), [](std::span<const EdgeUse> edge) {
    int balance = 0;
    for (const EdgeUse& use : edge) balance += use.forward ? 1 : -1;
    EXPECT_EQ(balance, 0);
  });
}

TEST(ClosedSurface, LeavesASoundOneAsItIs) {
  const TriangleMesh mesh = shapes::torus(20, 10);
  const ClosedSurface surface = closed(mesh);
  EXPECT_EQ(surface.mesh.triangles, mesh.triangles);
  EXPECT_EQ(surface.mesh.points, mesh.points);
  EXPECT_EQ(surface.lidsBegin, 400);
  EXPECT_EQ(surface.partCount, 1);
  EXPECT_FALSE(surface.wasInsideOut);
  EXPECT_EQ(surface.openEdges + surface.droppedTriangles + surface.turnedParts + surface.turnedTriangles, 0);
}

TEST(ClosedSurface, ClosesHolesInTheirPlane) {
  TriangleMesh cube = shapes::cube();
  cube.triangles.resize(10);  // without x = 1
  const ClosedSurface surface = closed(cube);
  expectCycle(surface);
  EXPECT_EQ(surface.openEdges, 4);
  EXPECT_EQ(surface.holes, 1);
  EXPECT_EQ(surface.lidsBegin, 10);
  EXPECT_DOUBLE_EQ(surface.volume, 1);
}

TEST(ClosedSurface, TurnsABodyInsideOutWithItsCavity) {
  const TriangleMesh hollow = bodies::together(
      shapes::sphere(24), shapes::flipped(bodies::placed(shapes::sphere(24), Vector3d::Zero(),
                                                         0.5 * Eigen::Matrix3d::Identity())));
  const ClosedSurface surface = closed(shapes::flipped(hollow));
  EXPECT_TRUE(surface.wasInsideOut);
  EXPECT_EQ(surface.partCount, 2);
  EXPECT_DOUBLE_EQ(surface.volume, bodies::volumeOf(hollow));
}

TEST(ClosedSurface, TurnsTheOneOfTwoPartsThatIsInsideOutThoughItHasAHole) {
  const TriangleMesh holed = bodies::cut(shapes::sphere(24), {1, 0, 0}, 0.9f);
  const ClosedSurface surface =
      closed(bodies::together(holed, shapes::flipped(bodies::placed(holed, {5, 0, 0}))));
  expectCycle(surface);
  EXPECT_EQ(surface.turnedParts, 1);
  EXPECT_NEAR(surface.volume, 2 * closed(holed).volume, 1e-6);
}

TEST(ClosedSurface, MendsDuplicatesAndSingleTurnedTriangles) {
  TriangleMesh mesh = shapes::sphere(24);
  const double volume = bodies::volumeOf(mesh);
  const auto before = mesh.triangles;
  mesh.triangles.insert(mesh.triangles.end(), before.begin(), before.begin() + 50);
  mesh.triangles.emplace_back(3, 3, 4);
  for (int t = 100; t < 120; ++t) std::swap(mesh.triangles[t][0], mesh.triangles[t][1]);
  const ClosedSurface surface = closed(mesh);
  expectCycle(surface);
  EXPECT_EQ(surface.droppedTriangles, 51);
  EXPECT_EQ(surface.turnedTriangles, 20);
  EXPECT_EQ(surface.openEdges, 0);
  EXPECT_NEAR(surface.volume, volume, 1e-12);
}

TEST(ClosedSurface, JoinsTrianglesWithCornersOfTheirOwn) {
  const TriangleMesh sphere = shapes::sphere(24);
  TriangleMesh loose;
  for (const Eigen::Vector3i& triangle : sphere.triangles) {
    const int first = static_cast<int>(loose.points.size());
    for (const int corner : triangle) loose.points.push_back(sphere.points[corner]);
    loose.triangles.emplace_back(first, first + 1, first + 2);
  }
  const ClosedSurface surface = closed(loose);
  EXPECT_EQ(surface.openEdges, 0);
  EXPECT_EQ(surface.partCount, 1);
}

std::string refusal(const TriangleMesh& mesh) {
  try {
    closed(mesh);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "none";
}

TEST(ClosedSurface, RefusesWhatIsNone) {
  EXPECT_EQ(refusal({}), "triangles: there are none");
  EXPECT_EQ(refusal({{{0, 0, 0}}, {{0, 0, 7}}}), "triangles: triangle 0 uses point 7 of 1");
  const float nan = std::numeric_limits<float>::quiet_NaN();
  EXPECT_EQ(refusal({{{0, 0, nan}}, {{0, 0, 0}}}), "points: point 0 is not finite");
  EXPECT_EQ(refusal({{{0, 0, 0}}, std::vector<Eigen::Vector3i>(kMostSurfaceTriangles + 1, {0, 0, 7})}),
            "triangles: there are 4000001, at most 4000000 are taken");
  TriangleMesh tube = shapes::cube();
  tube.triangles.resize(8);  // without x = 0 and x = 1
  EXPECT_EQ(refusal(tube), "triangles: no closed surface: 8 of 16 edges are open, around 2 holes");
  std::mt19937 random(1);
  EXPECT_EQ(refusal(shapes::soup(100, random)),
            "triangles: no closed surface: 300 of 300 edges are open, around 100 holes");
}

}  // namespace
}  // namespace pleura
