#include <algorithm>
#include <stdexcept>

#include "shapes.h"
#include <gtest/gtest.h>

#include <pleura/nodes/deformable/mesh/topology.h>

namespace pleura {
namespace {

int eulerCharacteristic(const TriangleMesh& mesh) {
  const auto e = edges(mesh.points.size(), mesh.triangles).size();
  return static_cast<int>(mesh.points.size()) - static_cast<int>(e) + static_cast<int>(mesh.triangles.size());
}

TEST(Topology, EulerCharacteristicIsTwoForASphereAndZeroForATorus) {
  EXPECT_EQ(eulerCharacteristic(shapes::cube()), 2);
  EXPECT_EQ(eulerCharacteristic(shapes::sphere(16)), 2);
  EXPECT_EQ(eulerCharacteristic(shapes::torus(16, 8)), 0);
}

TEST(Topology, EdgesAreSortedAndTellNeighboursBothWays) {
  const TriangleMesh mesh = shapes::torus(12, 7);
  const auto all = edges(mesh.points.size(), mesh.triangles);
  const Adjacency adjacent = neighbours(mesh.points.size(), mesh.triangles);
  ASSERT_EQ(adjacent.rows(), static_cast<int>(mesh.points.size()));
  EXPECT_EQ(adjacent.items.size(), 2 * all.size());
  for (const Eigen::Vector2i& edge : all) {
    EXPECT_LT(edge[0], edge[1]);
    EXPECT_TRUE(std::ranges::binary_search(adjacent[edge[0]], edge[1]));
    EXPECT_TRUE(std::ranges::binary_search(adjacent[edge[1]], edge[0]));
  }
  for (int i = 0; i < adjacent.rows(); ++i) {
    EXPECT_EQ(adjacent[i].size(), 6u);
    EXPECT_TRUE(std::ranges::is_sorted(adjacent[i]));
  }
}

TEST(Topology, IncidentTrianglesAreThoseThatUseThePoint) {
  const TriangleMesh mesh = shapes::sphere(10);
  const Adjacency incident = incidentTriangles(mesh.points.size(), mesh.triangles);
  EXPECT_EQ(incident.items.size(), 3 * mesh.triangles.size());
  for (int i = 0; i < incident.rows(); ++i)
    for (const int t : incident[i]) EXPECT_TRUE((mesh.triangles[t].array() == i).any());
}

TEST(Topology, ATriangleThatRepeatsAPointCountsOnceAndHasNoLoop) {
  const std::vector<Eigen::Vector3i> triangles = {{0, 0, 1}, {2, 1, 2}, {3, 3, 3}};
  const Adjacency incident = incidentTriangles(4, triangles);
  EXPECT_EQ(incident.items, (std::vector<int>{0, 0, 1, 1, 2}));
  EXPECT_EQ(edges(4, triangles), (std::vector<Eigen::Vector2i>{{0, 1}, {1, 2}}));
}

TEST(Topology, RefusesIndicesOutOfRange) {
  for (const int bad : {-1, 3, 1 << 30}) {
    const std::vector<Eigen::Vector3i> triangles = {{0, 1, 2}, {0, 1, bad}};
    EXPECT_THROW(incidentTriangles(3, triangles), std::invalid_argument);
    EXPECT_THROW(neighbours(3, triangles), std::invalid_argument);
    EXPECT_THROW(edges(3, triangles), std::invalid_argument);
  }
}

}  // namespace
}  // namespace pleura
