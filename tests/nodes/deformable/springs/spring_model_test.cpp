#include <functional>
#include <limits>
#include <stdexcept>
#include <string>

#include "elastic_surface.h"
#include <gtest/gtest.h>

#include <pleura/nodes/deformable/mesh/topology.h>

namespace pleura {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

void expectRefused(const std::function<void()>& make, const std::string& word) {
  try {
    make();
    ADD_FAILURE() << word << " was accepted";
  } catch (const std::invalid_argument& error) {
    EXPECT_NE(std::string(error.what()).find(word), std::string::npos) << error.what();
  }
}

TEST(SpringModel, HasASpringAnEdgeAsLongAsMeshed) {
  const ElasticSurface surface(geodesicSphere(4, 2));
  const SpringModel& model = surface.model;
  const auto pairs = edges(surface.mesh.points.size(), surface.mesh.triangles);
  ASSERT_EQ(model.end.size(), pairs.size());
  for (int a = 0, s = 0; a < model.pointCount(); ++a)
    for (; s < model.begin[a + 1]; ++s) {
      EXPECT_EQ(Eigen::Vector2i(a, model.end[s]), pairs[s]);
      EXPECT_EQ(model.length[s], (model.rest[a] - model.rest[model.end[s]]).norm());
    }
}

// p = K dV / V of a sphere under a small pressure.
TEST(SpringModel, HoldsAVolumeAHundredTimesStifferThanItsSprings) {
  ElasticSurface surface(geodesicSphere(6, 1), {{100}, {1}, 0}, PressureInterior{1e-2});
  const SpringReport report = surface.solve({}, {}, {1e-10, 50, 500});
  ASSERT_TRUE(report.converged);
  const double K = 1e-2 / (report.volume / surface.model.restVolume - 1);
  EXPECT_NEAR(surface.model.holdModulus / K, 100, 5);
}

TEST(SpringModel, RefusesMaterialOutOfRangeAndNamesIt) {
  const TriangleMesh mesh = geodesicSphere(1, 1);
  for (const double k : {0.0, -1.0, kNan, kInfinity})
    expectRefused([&] { ElasticSurface(mesh, {{k}, {1}, 0}); }, "stiffness 0");
  for (const double m : {-1.0, kNan, kInfinity})
    expectRefused([&] { ElasticSurface(mesh, {{1}, {m}, 0}); }, "mass 0");
  for (const double t : {-1.0, kNan})
    expectRefused([&] { ElasticSurface(mesh, {{1}, {1}, t}); }, "relaxation");
  expectRefused([&] { ElasticSurface(mesh, {{1, 2, 3}, {1}, 0}); }, "3 values of stiffness for 30");
  expectRefused([&] { ElasticSurface(mesh, {{1}, {}, 0}); }, "0 values of mass for 12");
  for (const double amount : {-1.0, kNan})
    expectRefused([&] { ElasticSurface(mesh, {}, GasInterior{amount, 0}); }, "gas");
  expectRefused([&] { ElasticSurface(mesh, {}, GasInterior{1, -1}); }, "ambient");
  expectRefused([&] { ElasticSurface(mesh, {}, PressureInterior{kNan}); }, "pressure difference");
}

TEST(SpringModel, RefusesMeshesThatAreNone) {
  TriangleMesh mesh = geodesicSphere(1, 1);
  expectRefused([&] { ElasticSurface(TriangleMesh{mesh.points, {}}); }, "no triangles");
  expectRefused(
      [&] {
        ElasticSurface({{kMostSpringPoints + 1, mesh.points[0]}, mesh.triangles});
      },
      "1000001 points, at most 1000000");
  expectRefused(
      [&] {
        ElasticSurface({mesh.points, {kMostSpringTriangles + 1, mesh.triangles[0]}});
      },
      "4000001 triangles, at most 4000000");
  mesh.triangles[3][1] = 12;
  expectRefused([&] { ElasticSurface{mesh}; }, "uses point 12");
  mesh.triangles[3][1] = -1;
  expectRefused([&] { ElasticSurface{mesh}; }, "uses point -1");
  mesh = geodesicSphere(1, 1);
  mesh.points[5].y() = std::numeric_limits<float>::quiet_NaN();
  expectRefused([&] { ElasticSurface{mesh}; }, "rest point 5");
  mesh.points[5].y() = 2e12f;
  expectRefused([&] { ElasticSurface{mesh}; }, "rest point 5");
}

TEST(SpringModel, RefusesAnInteriorOfASurfaceThatDoesNotEncloseOne) {
  const TriangleMesh closed = geodesicSphere(2, 1);
  TriangleMesh open = closed, turned = closed, inside = closed, flat = closed;
  open.triangles.pop_back();
  std::swap(turned.triangles[7][0], turned.triangles[7][1]);
  for (Eigen::Vector3i& t : inside.triangles) std::swap(t[0], t[1]);
  for (Eigen::Vector3f& p : flat.points) p.z() = 0;
  for (const SpringInterior& interior :
       {SpringInterior(GasInterior{1, 0}), SpringInterior(PressureInterior{1}),
        SpringInterior(VolumeInterior())}) {
    expectRefused([&] { ElasticSurface(open, {}, interior); }, "closed surface");
    expectRefused([&] { ElasticSurface(turned, {}, interior); }, "closed surface");
    expectRefused([&] { ElasticSurface(inside, {}, interior); }, "facing outwards");
    expectRefused([&] { ElasticSurface(flat, {}, interior); }, "around a volume");
    EXPECT_NO_THROW(ElasticSurface(closed, {}, interior));
  }
  for (const TriangleMesh& mesh : {open, turned, inside, flat}) EXPECT_NO_THROW(ElasticSurface{mesh});
}

}  // namespace
}  // namespace pleura
