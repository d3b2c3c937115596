#include <cmath>

#include "pressure_at_rest.h"
#include <gtest/gtest.h>

#include <pleura/nodes/deformable/finite_element_deformer.h>
#include <pleura/nodes/deformable/mesh/measures.h>
#include <pleura/tests/nodes/deformable/chainmail/icosphere.h>
#include <pleura/tests/nodes/test_context.h>

namespace pleura {
namespace {

class FiniteElementDeformerTest : public ::testing::Test {
 protected:
  std::shared_ptr<FiniteElementDeformer> elements(const char* model, int count = 500,
                                                  const char* type = "HEXAHEDRON") {
    auto deformer = context.make<FiniteElementDeformer>([&](FiniteElementDeformer& d) {
      d.model.setValue(model);
      d.elements.setValue(count);
      d.elementType.setValue(type);
    });
    deformer->setRest(ball, {});
    return deformer;
  }

  /// The ball held where it is at its top.
  double volumeOf(FiniteElementDeformer& deformer) {
    std::vector<int> held;
    std::vector<Vec3f> places;
    for (std::size_t i = 0; i < ball.points.size(); ++i)
      if (ball.points[i].y() > 0.047f) {
        held.push_back(static_cast<int>(i));
        places.push_back(ball.points[i]);
      }
    std::vector<Vec3f> shape = ball.points;
    deformer.deform(held, places, shape);
    return signedVolume(shape, ball.triangles);
  }

  /// (V / V_0 - 1) K / p with the bulk modulus K = E / 3 (1 - 2 nu): 1 for a small pressure.
  double swelling(FiniteElementDeformer& deformer, float pressure) {
    const double bulk = deformer.youngsModulus.getValue() / (3 * (1 - 2 * deformer.poissonRatio.getValue()));
    deformer.pressure.setValue(pressure);
    return (volumeOf(deformer) / restVolume - 1) * bulk / pressure;
  }

  TestContext context;
  TriangleMesh ball = icosphere(4, 0.05f);
  double restVolume = signedVolume(ball.points, ball.triangles);
};

/// Cells cut by the surface count by how much of them is inside: what that leaves shrinks with them.
TEST_F(FiniteElementDeformerTest, ABallUnderPressureSwellsByItsBulkModulus) {
  const double coarse = swelling(*elements("LINEAR", 100), 5) - 1,
               fine = swelling(*elements("LINEAR", 2700), 5) - 1;
  EXPECT_LT(std::abs(fine), 0.03);
  EXPECT_LT(std::abs(fine), 0.5 * std::abs(coarse));
}

TEST_F(FiniteElementDeformerTest, EveryModelIsTheLinearOneWhereStrainsAreSmall) {
  const double expected = swelling(*elements("LINEAR", 300), 5);
  for (const char* model : {"COROTATIONAL", "NEO_HOOKEAN"})
    for (const float pressure : {5.f, -5.f})
      EXPECT_NEAR(swelling(*elements(model, 300), pressure), expected, 0.02) << model;
}

TEST_F(FiniteElementDeformerTest, OnlyPressureAboveThatAtRestCounts) {
  expectOnlyPressureAboveThatAtRestCounts(*elements("LINEAR"), restVolume,
                                          [this](auto& deformer) { return volumeOf(deformer); });
}

TEST_F(FiniteElementDeformerTest, AsManyElementsAsAreAskedForAreMadeAboutAndAnewWhenThatChanges) {
  const auto deformer = elements("LINEAR", 100);
  EXPECT_NEAR(deformer->elementCount.getValue(), 100, 40);
  deformer->elements.setValue(1000);
  volumeOf(*deformer);
  EXPECT_NEAR(deformer->elementCount.getValue(), 1000, 250);
}

/// Under pressure cubes and tetrahedra of the same nodes swell alike.
TEST_F(FiniteElementDeformerTest, TetrahedraAreTheCubesCutInFive) {
  const auto cubes = elements("LINEAR", 500), tetrahedra = elements("LINEAR", 2500, "TETRAHEDRON");
  EXPECT_EQ(tetrahedra->elementCount.getValue(), 5 * cubes->elementCount.getValue());
  EXPECT_NEAR(swelling(*tetrahedra, 5), swelling(*cubes, 5), 0.03);
  EXPECT_TRUE(context.warnings.empty());
}

TEST_F(FiniteElementDeformerTest, TetrahedraThatLockAreNamed) {
  const auto tetrahedra = elements("LINEAR", 500, "TETRAHEDRON");
  tetrahedra->poissonRatio.setValue(0.49F);
  volumeOf(*tetrahedra);
  EXPECT_EQ(context.warnings.size(), 1U);
  tetrahedra->elementType.setValue("HEXAHEDRON");
  volumeOf(*tetrahedra);
  EXPECT_EQ(context.warnings.size(), 1U);
}

TEST_F(FiniteElementDeformerTest, AnUnknownModelOrElementIsRefusedByName) {
  const auto refusalOf = [this](FiniteElementDeformer& deformer) -> std::string {
    try {
      volumeOf(deformer);
    } catch (const std::invalid_argument& refused) {
      return refused.what();
    }
    return "taken";
  };
  const auto deformer = elements("ELASTIC");
  EXPECT_EQ(refusalOf(*deformer), "model is LINEAR, COROTATIONAL or NEO_HOOKEAN, not ELASTIC");
  deformer->elementType.setValue("PRISM");
  EXPECT_EQ(refusalOf(*deformer), "elementType is HEXAHEDRON or TETRAHEDRON, not PRISM");
}

TEST_F(FiniteElementDeformerTest, WhatNothingHoldsIsAtRest) {
  const auto deformer = elements("COROTATIONAL");
  std::vector<Vec3f> shape(ball.points.size());
  deformer->deform({}, {}, shape);
  EXPECT_EQ(shape, ball.points);
}

}  // namespace
}  // namespace pleura
