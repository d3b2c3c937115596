#include "mesh_checks.h"
#include <gtest/gtest.h>

#include <pleura/nodes/thorax/anatomy/inner_line.h>
#include <pleura/nodes/thorax/anatomy/measurements.h>
#include <pleura/nodes/thorax/anatomy/ribs.h>

namespace pleura {
namespace {

float lengthOf(const std::vector<Eigen::Vector3f>& line) {
  float length = 0.0f;
  for (std::size_t i = 1; i < line.size(); ++i) length += (line[i] - line[i - 1]).norm();
  return length;
}

class Ribs : public ::testing::Test {
 protected:
  std::vector<Rib> ribs = generateRibs();
};

TEST_F(Ribs, AreTwelveOnEachSideInOrder) {
  ASSERT_EQ(ribs.size(), 24u);
  for (std::size_t i = 0; i < ribs.size(); ++i) {
    EXPECT_EQ(ribs[i].number, static_cast<int>(i % 12) + 1);
    EXPECT_EQ(ribs[i].side, i < 12 ? Side::Left : Side::Right);
    EXPECT_GT(sign(ribs[i].side) * ribs[i].centreline[kRibSamples / 2].x(), 0.03f) << ribs[i].name;
  }
  EXPECT_EQ(ribs[0].name, "RIB_L1");
  EXPECT_EQ(ribs[23].name, "RIB_R12");
}

TEST_F(Ribs, AreAsLongAsMeasured) {
  const Table summary = measurementTable("ribs_summary");
  for (std::size_t row = 0; row < summary.rows(); ++row) {
    const std::size_t i = static_cast<std::size_t>(summary.integer(row, "rib") - 1) +
                          (summary.text(row, "side") == "left" ? 0 : 12);
    const double measured = 1e-3 * summary.number(row, "length_mm");
    EXPECT_NEAR(lengthOf(ribs[i].centreline), measured, 0.01 * measured) << ribs[i].name;
  }
}

TEST_F(Ribs, AreClosedAndFaceOutwards) {
  for (const Rib& rib : ribs) {
    EXPECT_EQ(openOrTwistedEdges(rib.mesh), 0) << rib.name;
    EXPECT_GT(enclosedVolume(rib.mesh), 1e-6) << rib.name;
    EXPECT_LT(enclosedVolume(rib.mesh), 5e-5) << rib.name;
  }
}

TEST_F(Ribs, SlopeDownAndForwards) {
  for (const Rib& rib : ribs) EXPECT_LT(rib.sternalEnd.y(), rib.head.y() - 0.03f) << rib.name;
  for (const Rib& rib : ribs) {
    if (rib.number <= 10) {
      EXPECT_GT(rib.sternalEnd.z(), rib.head.z() + 0.02f) << rib.name;
    }
  }
}

TEST_F(Ribs, LeftAndRightMirrorEachOther) {
  for (std::size_t i = 0; i < 12; ++i) {
    for (std::size_t k = 0; k < kRibSamples; ++k) {
      const Eigen::Vector3f& right = ribs[i + 12].centreline[k];
      EXPECT_LT((ribs[i].centreline[k] - Eigen::Vector3f(-right.x(), right.y(), right.z())).norm(), 0.005f)
          << ribs[i].name << " sample " << k;
    }
  }
}

TEST_F(Ribs, LandmarksLieOnTheBone) {
  for (const Rib& rib : ribs) {
    EXPECT_LT((rib.head - rib.centreline.front()).norm(), 0.001f) << rib.name;
    float nearest = 1.0f;
    for (const auto& point : rib.mesh.points) nearest = std::min(nearest, (point - rib.tubercle).norm());
    EXPECT_LT(nearest, 0.001f) << rib.name;
    for (std::size_t k = 4; k + 4 < kRibSamples; ++k) {
      const Eigen::Vector3f out = rib.centreline[k] - rib.innerLine[k];
      EXPECT_GT(out.norm(), 0.001f) << rib.name;
      EXPECT_LT(out.norm(), 0.014f) << rib.name;
      EXPECT_GT(
          out.dot(rib.centreline[k] - lungAxisNear(rib.centreline[k].cast<double>(), rib.side).cast<float>()),
          0.0f)
          << rib.name;
    }
  }
}

}  // namespace
}  // namespace pleura
