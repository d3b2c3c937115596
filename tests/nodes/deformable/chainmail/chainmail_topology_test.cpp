#include <limits>
#include <stdexcept>

#include "organ.h"
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <pleura/nodes/deformable/chainmail/chainmail_order.h>
#include <pleura/nodes/deformable/chainmail/chainmail_topology.h>

namespace pleura {
namespace {

using ::testing::ElementsAre;

std::vector<int> neighboursOf(const ChainmailTopology& topology, int point) {
  return {topology.neighbour.begin() + topology.begin[point],
          topology.neighbour.begin() + topology.begin[point + 1]};
}

TEST(ChainmailTopology, LinksEachEdgeOfASphereOnceEachWay) {
  const TriangleMesh mesh = icosphere(5, 1);
  const ChainmailTopology topology = linkTriangles(mesh.points, mesh.triangles);
  EXPECT_EQ(topology.pointCount(), 10242);
  EXPECT_EQ(topology.linkCount(), 30720);
  for (int a = 0; a < topology.pointCount(); ++a) {
    const std::vector<int> row = neighboursOf(topology, a);
    EXPECT_TRUE(std::is_sorted(row.begin(), row.end()));
    EXPECT_EQ(std::adjacent_find(row.begin(), row.end()), row.end());
    for (const int b : row) {
      const std::vector<int> back = neighboursOf(topology, b);
      EXPECT_TRUE(std::binary_search(back.begin(), back.end(), a));
    }
  }
}

TEST(ChainmailTopology, ToleratesDegenerateTrianglesAndLonelyPoints) {
  const Points rest{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {9, 9, 9}};
  const std::vector<Eigen::Vector3i> triangles{{0, 0, 1}, {1, 1, 1}, {0, 1, 2}, {2, 1, 0}};
  const ChainmailTopology topology = linkTriangles(rest, triangles);
  EXPECT_THAT(neighboursOf(topology, 0), ElementsAre(1, 2));
  EXPECT_THAT(neighboursOf(topology, 1), ElementsAre(0, 2));
  EXPECT_THAT(neighboursOf(topology, 3), ElementsAre());
}

TEST(ChainmailTopology, JoinsPointsAtTheSamePlace) {
  const Points rest{{0, 0, 0}, {1, 0, 0}, {-0.0f, 0, 0}, {1, 0, 1}, {0, 0, 0}};
  const ChainmailTopology topology = linkEdges(rest, {});
  EXPECT_THAT(neighboursOf(topology, 0), ElementsAre(2));
  EXPECT_THAT(neighboursOf(topology, 2), ElementsAre(0, 4));
  EXPECT_EQ(topology.linkCount(), 2);
}

TEST(ChainmailTopology, OfNothingIsEmpty) {
  const ChainmailTopology topology = linkTriangles({}, {});
  EXPECT_EQ(topology.pointCount(), 0);
  EXPECT_EQ(topology.linkCount(), 0);
}

TEST(ChainmailTopology, RefusesIndicesOutOfRangeAndPointsThatAreNotFinite) {
  const Points rest{{0, 0, 0}, {1, 0, 0}};
  EXPECT_THROW(linkEdges(rest, std::vector<Eigen::Vector2i>{{0, 2}}), std::invalid_argument);
  EXPECT_THROW(linkTriangles(rest, std::vector<Eigen::Vector3i>{{-1, 0, 1}}), std::invalid_argument);
  for (const float bad :
       {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity(), 1e31f})
    EXPECT_THROW(linkEdges(Points{{0, bad, 0}}, {}), std::invalid_argument);
}

TEST(ChainmailOrder, KeepsTheLinksAndBringsNeighboursTogether) {
  const TriangleMesh mesh = icosphere(4, 1);
  const ChainmailTopology topology = linkTriangles(mesh.points, mesh.triangles);
  const ChainmailOrder order = breadthFirstOrder(topology);
  const ChainmailTopology inner = renumber(topology, order);
  ASSERT_EQ(inner.begin.size(), topology.begin.size());
  int farthest = 0;
  for (int a = 0; a < topology.pointCount(); ++a) {
    EXPECT_EQ(order.outer[order.inner[a]], a);
    std::vector<int> row = neighboursOf(inner, order.inner[a]);
    for (int& b : row) {
      farthest = std::max(farthest, std::abs(b - order.inner[a]));
      b = order.outer[b];
    }
    std::sort(row.begin(), row.end());
    EXPECT_EQ(row, neighboursOf(topology, a));
  }
  EXPECT_LT(farthest, topology.pointCount() / 10);
}

}  // namespace
}  // namespace pleura
