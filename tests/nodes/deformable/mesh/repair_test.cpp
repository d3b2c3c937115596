#include <cmath>
#include <limits>
#include <stdexcept>

#include "shapes.h"
#include <gtest/gtest.h>

#include <pleura/nodes/deformable/mesh/mesh_report.h>
#include <pleura/nodes/deformable/mesh/orientation.h>
#include <pleura/nodes/deformable/mesh/repair.h>

namespace pleura {
namespace {

using Eigen::Vector3f;
using Eigen::Vector3i;

constexpr float nan = std::numeric_limits<float>::quiet_NaN();
constexpr float infinity = std::numeric_limits<float>::infinity();

/// What repair promises of any input.
void expectSound(const TriangleMesh& mesh) {
  const MeshReport report = analyze(mesh);
  EXPECT_EQ(report.nonFinitePoints, 0);
  EXPECT_EQ(report.unreferencedPoints, 0);
  EXPECT_EQ(report.outOfRangeTriangles, 0);
  EXPECT_EQ(report.degenerateTriangles, 0);
  EXPECT_EQ(report.nonManifoldEdges, 0);
  EXPECT_EQ(report.misorientedEdges, 0);
}

TriangleMesh joined(TriangleMesh a, const TriangleMesh& b, const Vector3f& shift = Vector3f::Zero(),
                    float scale = 1) {
  const int offset = static_cast<int>(a.points.size());
  for (const Vector3f& point : b.points) a.points.push_back(scale * point + shift);
  for (const Vector3i& triangle : b.triangles) a.triangles.push_back(triangle.array() + offset);
  return a;
}

/// Every triangle with points of its own, as STL has them.
TriangleMesh exploded(const TriangleMesh& mesh) {
  TriangleMesh result;
  for (const Vector3i& triangle : mesh.triangles) {
    const int first = static_cast<int>(result.points.size());
    for (const int corner : triangle) result.points.push_back(mesh.points[corner]);
    result.triangles.emplace_back(first, first + 1, first + 2);
  }
  return result;
}

TEST(Repair, LeavesASoundSurfaceAlone) {
  for (const TriangleMesh& mesh : {shapes::cube(), shapes::sphere(12), shapes::torus(12, 8)}) {
    TriangleMesh repaired = mesh;
    EXPECT_TRUE(deeds(repair(repaired)).empty());
    EXPECT_EQ(repaired.points, mesh.points);
    EXPECT_EQ(repaired.triangles, mesh.triangles);
  }
}

TEST(Repair, WeldsATriangleSoupToTheSurfaceItWas) {
  TriangleMesh mesh = exploded(shapes::torus(24, 12));
  EXPECT_TRUE(analyze(mesh).isSoup);
  EXPECT_EQ(repair(mesh).weldedPoints, 5 * 24 * 12);
  const MeshReport report = analyze(mesh);
  EXPECT_TRUE(report.isClosed);
  EXPECT_EQ(report.points, 24 * 12);
}

TEST(Repair, WeldsWithinADistanceAcrossCells) {
  TriangleMesh mesh = exploded(shapes::sphere(16));
  std::mt19937 random(1);
  for (Vector3f& point : mesh.points) point += shapes::randomPoint(random, 1e-4).cast<float>();
  TriangleMesh exactOnly = mesh;
  repair(exactOnly);
  EXPECT_FALSE(analyze(exactOnly).isClosed);
  repair(mesh, {.weldDistance = 1e-3});
  EXPECT_TRUE(analyze(mesh).isClosed);
}

TEST(Repair, TurnsScrambledTrianglesOutwards) {
  std::mt19937 random(2);
  TriangleMesh mesh = shapes::torus(20, 10);
  const double volume = analyze(mesh).volume;
  for (Vector3i& triangle : mesh.triangles)
    if (random() % 2 == 0) std::swap(triangle[0], triangle[1]);
  EXPECT_GT(analyze(mesh).misorientedEdges, 0);
  repair(mesh);
  expectSound(mesh);
  EXPECT_NEAR(analyze(mesh).volume, volume, 1e-6);
}

TEST(Repair, LeavesAnOpenSheetFacingAsMostOfItDid) {
  TriangleMesh sheet = shapes::sphere(12);
  std::erase_if(sheet.triangles, [&sheet](const Vector3i& t) { return sheet.points[t.minCoeff()].z() < 0; });
  const TriangleMesh before = sheet;
  std::swap(sheet.triangles[0][1], sheet.triangles[0][2]);
  EXPECT_EQ(repair(sheet, {.maxHoleEdges = 0}).turnedTriangles, 1);
  EXPECT_EQ(analyze(sheet).volume, analyze(before).volume);
}

TEST(Repair, TurnsAnInsideOutPartButNotACavity) {
  const TriangleMesh inner = shapes::flipped(shapes::sphere(12));
  TriangleMesh beside = joined(shapes::sphere(12), inner, {3, 0, 0});
  EXPECT_EQ(analyze(beside).insideOutComponents, 1);
  EXPECT_EQ(repair(beside).turnedParts, 1);
  EXPECT_EQ(analyze(beside).insideOutComponents, 0);

  TriangleMesh hollow = joined(shapes::sphere(12), inner, {0.1f, 0, 0}, 0.5f);
  const double volume = analyze(hollow).volume;
  EXPECT_EQ(repair(hollow).turnedParts, 0);
  EXPECT_EQ(analyze(hollow).volume, volume);
}

TEST(Repair, TellsCavitiesWithinABoundOfWork) {
  TriangleMesh hollow = joined(shapes::sphere(12), shapes::flipped(shapes::sphere(12)), {0.1f, 0, 0}, 0.5f);
  // A ray out of each of the cavity's triangles crosses no more than all of both.
  const std::size_t enough = hollow.triangles.size() / 2 * hollow.triangles.size();
  EXPECT_EQ(faceOutwards(hollow.points, hollow.triangles, enough), 0);
  const auto before = hollow.triangles;
  EXPECT_THROW(faceOutwards(hollow.points, hollow.triangles, 10), std::invalid_argument);
  EXPECT_EQ(hollow.triangles, before);
}

TEST(Repair, FillsHolesUpToTheGivenLength) {
  TriangleMesh holed = shapes::sphere(16);
  const double volume = analyze(holed).volume;
  holed.triangles.erase(holed.triangles.begin() + 40);
  std::erase_if(holed.triangles, [&](const Vector3i& t) { return holed.points[t.maxCoeff()].z() == 1; });
  EXPECT_EQ(analyze(holed).holes, (std::vector<int>{16, 3}));

  TriangleMesh smallOnly = holed;
  EXPECT_EQ(repair(smallOnly, {.maxHoleEdges = 15}).filledHoles, 1);
  EXPECT_EQ(analyze(smallOnly).holes, std::vector<int>{16});

  EXPECT_EQ(repair(holed).filledHoles, 2);
  expectSound(holed);
  EXPECT_TRUE(analyze(holed).isClosed);
  EXPECT_NEAR(analyze(holed).volume, volume, 0.02 * volume);
}

TEST(Repair, DoesNotTakeAnOutlineForAHole) {
  TriangleMesh strip;
  for (int i = 0; i < 12; ++i)
    strip.points.emplace_back(static_cast<float>(i), static_cast<float>(i % 2), 0.f);
  for (int i = 0; i + 2 < 12; ++i) strip.triangles.emplace_back(i, i + 1, i + 2);
  EXPECT_EQ(repair(strip).filledHoles, 0);
  EXPECT_EQ(strip.triangles.size(), 10u);
}

TEST(Repair, PartsSheetsThatTouchAlongAnEdgeOrAtAPoint) {
  // two tetrahedra that share edge 0-1, or point 0 alone
  const std::vector<Vector3f> points = {{0, 0, 0}, {0, 0, 1}, {1, 0, 0}, {1, 1, 0}, {-1, 0, 0}, {-1, -1, 0}};
  const auto tetrahedron = [](int a, int b, int c, int d) {
    return std::vector<Vector3i>{{a, c, b}, {a, b, d}, {b, c, d}, {a, d, c}};
  };
  TriangleMesh mesh{points, tetrahedron(0, 1, 2, 3)};
  for (const Vector3i& triangle : tetrahedron(0, 1, 4, 5)) mesh.triangles.push_back(triangle);
  EXPECT_EQ(analyze(mesh).nonManifoldEdges, 1);
  const RepairReport done = repair(mesh);
  EXPECT_EQ(done.splitPoints, 2);
  expectSound(mesh);
  EXPECT_TRUE(analyze(mesh).isClosed);
  EXPECT_EQ(mesh.triangles.size(), 8u);
}

TEST(Repair, TakesOutFoldsWithoutThicknessButKeepsATwoSidedSheet) {
  TriangleMesh folded = shapes::sphere(12);
  folded.points.emplace_back(2.f, 0.f, 0.f);
  const int tip = static_cast<int>(folded.points.size()) - 1;
  folded.triangles.emplace_back(0, 1, tip);
  folded.triangles.emplace_back(1, 0, tip);
  EXPECT_EQ(analyze(folded).opposedTriangles, 2);
  repair(folded);
  EXPECT_TRUE(analyze(folded).isClosed);
  EXPECT_EQ(folded.triangles, shapes::sphere(12).triangles);

  TriangleMesh sheet;
  for (int row = 0; row < 3; ++row)
    for (int k = 0; k < 3; ++k)
      sheet.points.emplace_back(static_cast<float>(row), static_cast<float>(k), 0.f);
  for (const int i : {0, 1, 3, 4})
    for (const Vector3i& t : {Vector3i(i, i + 3, i + 1), Vector3i(i + 1, i + 3, i + 4)})
      sheet.triangles.push_back(t);
  const TriangleMesh oneSide = sheet;
  for (const Vector3i& t : shapes::flipped(sheet).triangles) sheet.triangles.push_back(t);
  repair(sheet);
  EXPECT_EQ(sheet.triangles, oneSide.triangles);
}

TEST(Repair, CutsAMoebiusStripOpen) {
  TriangleMesh mesh;
  const int n = 20;
  for (int i = 0; i < n; ++i) {
    const double a = 2 * std::numbers::pi * i / n;
    for (const double w : {-0.3, 0.3}) {
      const double r = 1 + w * std::cos(a / 2);
      mesh.points.push_back(
          Eigen::Vector3d(r * std::cos(a), r * std::sin(a), w * std::sin(a / 2)).cast<float>());
    }
  }
  for (int i = 0; i < n; ++i) {
    const int a = 2 * i, b = a + 1, twist = i + 1 == n ? 1 : 0;
    const int c = (2 * i + 2) % (2 * n) + twist, d = (2 * i + 2) % (2 * n) + 1 - twist;
    mesh.triangles.emplace_back(a, c, b);
    mesh.triangles.emplace_back(b, c, d);
  }
  repair(mesh, {.maxHoleEdges = 0});
  expectSound(mesh);
  EXPECT_EQ(mesh.triangles.size(), 2u * n);
  EXPECT_EQ(mesh.points.size(), 2u * n + 2);
}

TEST(Repair, RemovesWhatCannotBeUsed) {
  TriangleMesh mesh = shapes::cube();
  const std::size_t sound = mesh.triangles.size();
  mesh.points.emplace_back(nan, 0.f, 0.f);
  mesh.points.emplace_back(0.f, infinity, 0.f);
  mesh.points.emplace_back(5.f, 5.f, 5.f);
  for (const Vector3i& bad : {Vector3i(0, 1, 8), Vector3i(0, 9, 1), Vector3i(0, 1, 11), Vector3i(-1, 0, 1),
                              Vector3i(0, 0, 1), Vector3i(3, 1, 0)})
    mesh.triangles.push_back(bad);
  const MeshReport before = analyze(mesh);
  EXPECT_EQ(before.nonFinitePoints, 2);
  EXPECT_EQ(before.outOfRangeTriangles, 2);
  EXPECT_EQ(before.degenerateTriangles, 1);
  EXPECT_EQ(before.duplicateTriangles, 1);
  EXPECT_EQ(before.unreferencedPoints, 1);
  EXPECT_EQ(repair(mesh).droppedTriangles, 6);
  expectSound(mesh);
  EXPECT_EQ(mesh.triangles.size(), sound);
  EXPECT_EQ(mesh.points.size(), 8u);
}

TEST(Repair, MakesAnyGarbageSound) {
  std::mt19937 random(3);
  for (int round = 0; round < 1000; ++round) {
    TriangleMesh mesh;
    const int points = 1 + static_cast<int>(random() % (round % 3 == 0 ? 9 : 40)),
              triangles = static_cast<int>(random() % 200);
    for (int i = 0; i < points; ++i) {
      Vector3f point = shapes::randomPoint(random).cast<float>();
      if (random() % 20 == 0) point *= 1e30f;
      if (random() % 30 == 0) point[random() % 3] = random() % 2 == 0 ? nan : infinity;
      if (random() % 10 == 0 && i > 0) point = Vector3f(mesh.points[random() % i]);
      mesh.points.push_back(point);
    }
    const auto index = [&] {
      return static_cast<int>(random() % (points + 1)) - (random() % 50 == 0 ? 1 : 0);
    };
    for (int t = 0; t < triangles; ++t) {
      const int a = index(), b = index(), c = index();
      mesh.triangles.emplace_back(a, b, c);
    }
    faults(analyze(mesh));
    repair(mesh, {.weldDistance = round % 2 == 0 ? 0 : 0.05});
    expectSound(mesh);
  }
}

TEST(Repair, RefusesBadOptions) {
  TriangleMesh mesh = shapes::cube();
  EXPECT_THROW(repair(mesh, {.weldDistance = -1}), std::invalid_argument);
  EXPECT_THROW(repair(mesh, {.weldDistance = std::nan("")}), std::invalid_argument);
  EXPECT_THROW(repair(mesh, {.weldDistance = 1e-300}), std::invalid_argument);
  EXPECT_THROW(repair(mesh, {.maxHoleEdges = -1}), std::invalid_argument);
}

TEST(Analyze, FindsNothingWrongWithASoundSurface) {
  const MeshReport report = analyze(shapes::torus(12, 8));
  EXPECT_TRUE(faults(report).empty());
  EXPECT_TRUE(report.isClosed);
  EXPECT_FALSE(report.isSoup);
  EXPECT_EQ(report.components, 1);
  EXPECT_EQ(report.edges, 3 * 12 * 8);
}

TEST(Analyze, SaysWhatIsWrong) {
  TriangleMesh mesh = shapes::flipped(joined(shapes::cube(), shapes::cube(), {2, 0, 0}));
  mesh.triangles.pop_back();
  mesh.points.emplace_back(0.f, 0.f, 0.f);
  EXPECT_EQ(faults(analyze(mesh)),
            (std::vector<std::string>{"1 duplicate point", "1 point is in no triangle",
                                      "3 boundary edges around 1 hole (3)", "1 closed part is inside out"}));
  EXPECT_EQ(faults(analyze({})), std::vector<std::string>{"no triangles"});
}

}  // namespace
}  // namespace pleura
