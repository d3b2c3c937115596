#include <gtest/gtest.h>

#include <pleura/tests/nodes/deformable/chainmail/icosphere.h>
#include <pleura/x3d/browser/tradeoff/shape_error.h>

namespace pleura {
namespace {

using Shapes = std::vector<std::vector<Vec3f>>;

std::vector<Vec3f> moved(std::vector<Vec3f> points, const Vec3f& by) {
  for (Vec3f& point : points) point += by;
  return points;
}

class ShapeErrorTest : public ::testing::Test {
 protected:
  const TriangleMesh ball = icosphere(3, 0.05f);
  const Shapes reference{ball.points, ball.points};
};

TEST_F(ShapeErrorTest, OfTheReferenceIsNone) {
  const ShapeError error = shapeError(reference, reference, ball.triangles, {});
  EXPECT_EQ(error.rms, 0);
  EXPECT_EQ(error.most, 0);
  EXPECT_EQ(error.volume, 0);
}

TEST_F(ShapeErrorTest, OfWhatIsMovedIsHowFar) {
  const Shapes shapes(2, moved(ball.points, {0, 0.003f, 0.004f}));
  const ShapeError error = shapeError(shapes, reference, ball.triangles, {});
  EXPECT_NEAR(error.rms, 0.005, 1e-8);
  EXPECT_NEAR(error.percentile95, 0.005, 1e-8);
  EXPECT_NEAR(error.most, 0.005, 1e-8);
  EXPECT_NEAR(error.volume, 0, 1e-6);
}

TEST_F(ShapeErrorTest, OneMomentAndOnePointOutOfPlaceCountAsTheyAre) {
  Shapes shapes = reference;
  shapes[1][7] += Vec3f(0.01f, 0, 0);
  const ShapeError error = shapeError(shapes, reference, ball.triangles, {});
  const double count = 2.0 * static_cast<double>(ball.points.size());
  EXPECT_NEAR(error.rms, 0.01 / std::sqrt(count), 1e-8);
  EXPECT_EQ(error.percentile95, 0);
  EXPECT_NEAR(error.most, 0.01, 1e-8);
}

/// What is driven is right in every shape: it would make errors look small.
TEST_F(ShapeErrorTest, DrivenPointsDoNotCount) {
  Shapes shapes = reference;
  for (auto& shape : shapes) shape = moved(shape, {0, 0, 0.005f});
  std::vector<int> driven;
  for (int i = 0; i < static_cast<int>(ball.points.size()); i += 2) {
    driven.push_back(i);
    for (auto& shape : shapes) shape[static_cast<std::size_t>(i)] = ball.points[static_cast<std::size_t>(i)];
  }
  EXPECT_NEAR(shapeError(shapes, reference, ball.triangles, driven).rms, 0.005, 1e-8);
  EXPECT_NEAR(shapeError(shapes, reference, ball.triangles, {}).rms, 0.005 / std::sqrt(2.0), 2e-5);
}

TEST_F(ShapeErrorTest, FiveInAHundredMayBeFurtherOff) {
  const auto percentileWith = [&](double share) {
    Shapes shapes{ball.points};
    const auto count = static_cast<std::size_t>(share * static_cast<double>(ball.points.size()));
    for (std::size_t i = 0; i < count; ++i) shapes[0][i] += Vec3f(0.01f, 0, 0);
    return shapeError(shapes, reference, ball.triangles, {}).percentile95;
  };
  EXPECT_EQ(percentileWith(0.04), 0);
  EXPECT_NEAR(percentileWith(0.06), 0.01, 1e-8);
}

TEST_F(ShapeErrorTest, TheLargestExcessOrLackOfVolumeIsTold) {
  Shapes shapes = reference;
  for (Vec3f& point : shapes[0]) point *= 1.01f;
  for (Vec3f& point : shapes[1]) point *= 0.98f;
  EXPECT_NEAR(shapeError(shapes, reference, ball.triangles, {}).volume, std::pow(0.98, 3) - 1, 1e-5);
}

/// A sheet that lies 2 mm above the ball at rest: less than a centimetre about the pole only.
class MeasureContact : public ShapeErrorTest {
 protected:
  ShapeError contactWithSheetMoved(float up) {
    std::vector<Vec3f> sheet;
    for (int i = -5; i <= 5; ++i)
      for (int k = -5; k <= 5; ++k)
        sheet.emplace_back(0.002f * static_cast<float>(i), 0.052f, 0.002f * static_cast<float>(k));
    ShapeError error;
    measureContact({ball, sheet}, reference, Shapes{sheet, moved(sheet, {0, up, 0})}, error);
    return error;
  }
};

TEST_F(MeasureContact, WhatStaysHasNeitherGapNorPenetration) {
  const ShapeError error = contactWithSheetMoved(0);
  EXPECT_NEAR(error.gap, 0, 1e-7);
  EXPECT_EQ(error.penetration, 0);
}

TEST_F(MeasureContact, WhatComesOffHasAGapBeyondThatAtRest) {
  const ShapeError error = contactWithSheetMoved(0.003f);
  EXPECT_NEAR(error.gap, 0.003, 1e-4);
  EXPECT_EQ(error.penetration, 0);
}

TEST_F(MeasureContact, TheClosedSurfaceMayBeWhatMoves) {
  std::vector<Vec3f> sheet{{0, 0.052f, 0}};
  ShapeError error;
  measureContact({ball, sheet}, Shapes{moved(ball.points, {0, -0.003f, 0})}, Shapes{sheet}, error);
  EXPECT_NEAR(error.gap, 0.003, 1e-4);
}

TEST_F(MeasureContact, WhatGoesInPenetratesByWhatIsInside) {
  const ShapeError error = contactWithSheetMoved(-0.005f);
  EXPECT_NEAR(error.penetration, 0.003, 1e-4);
  EXPECT_NEAR(error.gap, 0, 1e-7);
}

}  // namespace
}  // namespace pleura
