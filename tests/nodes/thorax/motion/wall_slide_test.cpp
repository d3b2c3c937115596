#include <limits>

#include "ring_cage.h"
#include <gtest/gtest.h>

#include <pleura/nodes/thorax/motion/wall_slide.h>

namespace pleura {
namespace {

std::vector<Eigen::Vector3d> circle(double height) {
  std::vector<Eigen::Vector3d> points;
  for (int k = 0; k < 200; ++k) {
    const double angle = 2.0 * std::numbers::pi * k / 200.0;
    points.emplace_back(0.094 * std::cos(angle), height, 0.094 * std::sin(angle));
  }
  return points;
}

/// Height of the wall at v and contraction, on a column.
double heightAt(const RingCage& cage, const WallSlide& slide, int column, double v, double contraction) {
  const double row = slide.row(column, v, contraction);
  const int above = static_cast<int>(row);
  const double t = row - above;
  return (1.0 - t) * cage.wall.rest[PleuralWall::index(column, above)].y() +
         t * cage.wall.rest[PleuralWall::index(column, above + 1)].y();
}

TEST(WallSlide, FindsFoldAndRimWhereTheyWere) {
  const RingCage cage;
  const WallSlide slide = slideOnWall(cage.wall, circle(0.02), circle(-0.06), 0.03);
  for (int column = 0; column < PleuralWall::kColumns; ++column) {
    EXPECT_NEAR(heightAt(cage, slide, column, 1.0, 0.0), 0.02, 0.002);
    EXPECT_NEAR(heightAt(cage, slide, column, 2.0, 0.0), -0.06, 0.002);
  }
}

TEST(WallSlide, TheFoldDropsAndTheEndsStay) {
  const RingCage cage;
  const WallSlide slide = slideOnWall(cage.wall, circle(0.02), circle(-0.06), 0.03);
  EXPECT_NEAR(heightAt(cage, slide, 5, 1.0, 1.0), -0.01, 0.003);
  EXPECT_EQ(slide.row(5, 0.0, 1.0), 0.0);
  EXPECT_EQ(slide.row(5, 2.0, 1.0), slide.rim[5]);
}

TEST(WallSlide, NothingOvertakesAndTheZoneNeverVanishes) {
  const RingCage cage;
  const WallSlide slide =
      slideOnWall(cage.wall, circle(0.02), circle(-0.06), 0.5);  // far more than there is room
  for (const double contraction : {0.0, 0.3, 1.0}) {
    for (double v = 0.02; v <= 2.3; v += 0.02) {
      EXPECT_GT(slide.row(7, v, contraction), slide.row(7, v - 0.02, contraction)) << v;
    }
  }
  EXPECT_GT(heightAt(cage, slide, 7, 1.0, 1.0) - heightAt(cage, slide, 7, 2.0, 1.0), 0.02);
}

TEST(WallSlide, RefusesADiaphragmElsewhere) {
  const RingCage cage;
  const std::vector<Eigen::Vector3d> far{{0.0, 0.0, 0.0}};
  EXPECT_THROW(slideOnWall(cage.wall, far, circle(-0.06), 0.03), std::invalid_argument);
  EXPECT_THROW(slideOnWall(cage.wall, circle(0.0), circle(-0.06), std::numeric_limits<double>::infinity()),
               std::invalid_argument);
}

}  // namespace
}  // namespace pleura
