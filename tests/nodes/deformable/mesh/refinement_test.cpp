#include <algorithm>
#include <limits>
#include <stdexcept>

#include "shapes.h"
#include <gtest/gtest.h>

#include <pleura/nodes/deformable/mesh/measures.h>
#include <pleura/nodes/deformable/mesh/mesh_report.h>
#include <pleura/nodes/deformable/mesh/refinement.h>
#include <pleura/nodes/deformable/mesh/surface_query.h>
#include <pleura/nodes/deformable/mesh/topology.h>

namespace pleura {
namespace {

using Eigen::Vector3f;

TEST(Subdivide, KeepsShapeAndTopology) {
  const TriangleMesh coarse = shapes::torus(10, 6), fine = subdivide(coarse);
  const MeshReport before = analyze(coarse), after = analyze(fine);
  EXPECT_EQ(after.triangles, 4 * before.triangles);
  EXPECT_EQ(after.points, before.points + before.edges);
  EXPECT_TRUE(faults(after).empty());
  EXPECT_NEAR(after.volume, before.volume, 1e-6);
  EXPECT_NEAR(after.area, before.area, 1e-5);
  for (std::size_t i = 0; i < coarse.points.size(); ++i) EXPECT_EQ(fine.points[i], coarse.points[i]);
}

TEST(Subdivide, BearsDegenerateTriangles) {
  const TriangleMesh fine = subdivide({{{0, 0, 0}, {1, 0, 0}}, {{0, 0, 1}, {1, 1, 1}}});
  EXPECT_EQ(fine.triangles.size(), 8u);
  EXPECT_EQ(fine.points.size(), 3u);
}

float longestEdge(const TriangleMesh& mesh) {
  float longest = 0;
  for (const Eigen::Vector2i& e : edges(mesh.points.size(), mesh.triangles))
    longest = std::max(longest, (mesh.points[e[0]] - mesh.points[e[1]]).norm());
  return longest;
}

TEST(SplitLongEdges, KeepsShapeAndTopology) {
  const TriangleMesh coarse = shapes::torus(10, 6);
  for (const float share : {0.9f, 0.6f, 0.3f}) {  // one, two and all sides of triangles
    const float longest = share * longestEdge(coarse);
    const TriangleMesh fine = splitLongEdges(coarse, longest, [](const Vector3f&) { return true; });
    EXPECT_LE(longestEdge(fine), longest);
    const MeshReport before = analyze(coarse), after = analyze(fine);
    EXPECT_GT(after.points, before.points);
    EXPECT_TRUE(faults(after).empty());
    EXPECT_NEAR(after.volume, before.volume, 1e-6);
    EXPECT_NEAR(after.area, before.area, 1e-5);
    for (std::size_t i = 0; i < coarse.points.size(); ++i) EXPECT_EQ(fine.points[i], coarse.points[i]);
  }
}

TEST(SplitLongEdges, LeavesWhatIsNotChosenAlone) {
  const TriangleMesh coarse = shapes::torus(10, 6);
  const TriangleMesh fine = splitLongEdges(coarse, 0.01f, [](const Vector3f& p) { return p.x() > 0; });
  EXPECT_GT(fine.points.size(), coarse.points.size());
  for (std::size_t i = coarse.points.size(); i < fine.points.size(); ++i) EXPECT_GT(fine.points[i].x(), 0);
}

TEST(Decimate, KeepsASphereCloseAndClosed) {
  const TriangleMesh fine = shapes::sphere(64), coarse = decimate(fine, 1000);
  EXPECT_LE(coarse.triangles.size(), 1000u);
  EXPECT_GE(coarse.triangles.size(), 950u);
  EXPECT_TRUE(faults(analyze(coarse)).empty());
  const SurfaceQuery surface(coarse.points, coarse.triangles);
  for (const Vector3f& point : fine.points)
    EXPECT_LT(surface.closestPoint(point.cast<double>()).distance, 0.02);
}

TEST(Decimate, KeepsTheHoleOfATorus) {
  const MeshReport report = analyze(decimate(shapes::torus(30, 20), 100));
  EXPECT_LE(report.triangles, 100);
  EXPECT_EQ(report.points - report.edges + report.triangles, 0);
  EXPECT_TRUE(report.isClosed);
}

TEST(Decimate, LeavesASurfaceWithNoMoreThanAskedAlone) {
  EXPECT_EQ(decimate(shapes::cube(), 12).triangles, shapes::cube().triangles);
  EXPECT_TRUE(decimate({}, 10).triangles.empty());
}

TEST(Refinement, RefusesBadInput) {
  TriangleMesh mesh = shapes::cube();
  EXPECT_THROW(decimate(mesh, -1), std::invalid_argument);
  mesh.triangles[3][1] = 8;
  EXPECT_THROW(decimate(mesh, 4), std::invalid_argument);
  EXPECT_THROW(subdivide(mesh), std::invalid_argument);
  const auto all = [](const Vector3f&) { return true; };
  EXPECT_THROW(splitLongEdges(mesh, 1, all), std::invalid_argument);
  mesh = shapes::cube();
  mesh.points[2].x() = std::numeric_limits<float>::quiet_NaN();
  EXPECT_THROW(decimate(mesh, 4), std::invalid_argument);
  EXPECT_THROW(splitLongEdges(mesh, 1, all), std::invalid_argument);
  EXPECT_THROW(splitLongEdges(shapes::cube(), 0, all), std::invalid_argument);
}

}  // namespace
}  // namespace pleura
