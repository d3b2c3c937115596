#include <atomic>
#include <chrono>
#include <limits>
#include <thread>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <pleura/nodes/deformable/finite_element_deformer.h>
#include <pleura/nodes/deformable/mesh/measures.h>
#include <pleura/nodes/deformable/solve_counter.h>
#include <pleura/nodes/standard/geometry3d/indexed_face_set.h>
#include <pleura/nodes/standard/rendering/coordinate.h>
#include <pleura/nodes/thorax/deformable_shape2.h>
#include <pleura/tests/nodes/deformable/chainmail/icosphere.h>
#include <pleura/tests/nodes/deformable/in_threads.h>
#include <pleura/tests/nodes/test_context.h>

namespace pleura {
namespace {

/// Takes no shape while its modulus is 0, and counts how often it is given one. Long enough at work to be
/// worth a helper.
class Particular : public DeformerNode {
 public:
  SFFloat modulus;
  int shapesGiven = 0;
  std::atomic<int> solves = 0;
  int reports = 0;

  static void declare(NodeType& type) {
    DeformerNode::declare(type);
    type.named("Particular", "Test");
    type.field<&Particular::modulus>("modulus", Access::inputOutput, 0);
  }
  void setRest(const TriangleMesh& rest, std::span<const int>) override {
    ++shapesGiven;
    if (modulus.getValue() == 0) throw std::invalid_argument("modulus: above 0 is expected");
    rest_ = rest;
  }
  void solve(std::span<const int>, std::span<const Vec3f> targets, std::span<Vec3f> positions) override {
    requireFinite(targets);
    std::this_thread::sleep_for(std::chrono::microseconds(200));
    for (std::size_t i = 0; i < positions.size(); ++i) positions[i] = rest_.points[i] + targets[0];
    ++solves;
  }
  void report() override { ++reports; }
  std::vector<Field*> inputs() override { return {&modulus}; }

 private:
  TriangleMesh rest_;
};

class DeformableShape2Test : public ::testing::Test {
 protected:
  /// Held by its first point, at `target` where there is one.
  std::shared_ptr<DeformableShape2> triangle(std::vector<Vec3f> target) {
    points = context.make<Coordinate>([](Coordinate& c) {
      c.point.setValue({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}});
    });
    const auto faces = context.make<IndexedFaceSet>([&](IndexedFaceSet& f) {
      f.coord.setValue(points);
      f.coordIndex.setValue({0, 1, 2, -1});
    });
    return context.make<DeformableShape2>([&](DeformableShape2& shape) {
      shape.geometry.setValue(faces);
      shape.deformer.setValue(deformer);
      shape.contactIndex.setValue({0});
      shape.contactPoint.setValue(std::move(target));
    });
  }

  void breathe(int frames) {
    for (int k = 0; k < frames; ++k) {
      organ->contactPoint.setValue({{0, 0, 0.1f * static_cast<float>(++moves_)}});
      organ->deformedCoord.upToDate();
    }
  }

  TestContext context;
  std::shared_ptr<Particular> deformer = context.make<Particular>();
  std::shared_ptr<Coordinate> points;
  std::shared_ptr<DeformableShape2> organ = triangle({});

 private:
  int moves_ = 0;
};

TEST_F(DeformableShape2Test, ADeformerThatRefusesTheShapeIsNotAskedAtEveryFrame) {
  breathe(3);
  EXPECT_EQ(deformer->shapesGiven, 1);
  EXPECT_EQ(organ->deformedCoord.getValue(), organ->origCoord.getValue());
  ASSERT_FALSE(context.warnings.empty());
  EXPECT_THAT(context.warnings.front(), ::testing::HasSubstr("modulus: above 0 is expected"));
}

TEST_F(DeformableShape2Test, IsAskedAgainOnceItsFieldsHaveChangedAndThenNoMore) {
  breathe(1);
  deformer->modulus.setValue(1);
  breathe(3);
  EXPECT_EQ(deformer->shapesGiven, 2);
  EXPECT_NEAR(organ->deformedCoord.getValue()[1].z(), 0.4f, 1e-6f);
}

TEST_F(DeformableShape2Test, AnotherShapeAtRestIsGivenToIt) {
  deformer->modulus.setValue(1);
  breathe(2);
  organ->origCoord.setValue({{0, 0, 1}, {1, 0, 1}, {0, 1, 1}});
  breathe(2);
  EXPECT_EQ(deformer->shapesGiven, 2);
  EXPECT_NEAR(organ->deformedCoord.getValue()[1].z(), 1.4f, 1e-6f);
}

TEST_F(DeformableShape2Test, WhatIsHeldFromTheBeginningIsShownThoughNothingChanges) {
  deformer->modulus.setValue(1);
  organ = nullptr;
  const auto held = triangle({{0, 0, 0.5f}});
  EXPECT_NEAR(points->point.getValue()[1].z(), 0.5f, 1e-6f);
}

TEST_F(DeformableShape2Test, WhatHasBegunIsSolvedOnceForWhatIsThenSo) {
  const InThreads all(2);
  deformer->modulus.setValue(1);
  organ->contactPoint.setValue({{0, 0, 0.5f}});
  const auto before = solveCounter();
  organ->begin();
  organ->begin();
  EXPECT_NEAR(organ->deformedCoord.getValue()[1].z(), 0.5f, 1e-6f);
  organ->begin();
  EXPECT_EQ(solveCounter(), before + 1);
  EXPECT_EQ(deformer->reports, 1);
  organ->contactPoint.setValue({{0, 0, 0.6f}});
  organ->begin();
  for (int k = 0; k < 10000 && deformer->solves < 2; ++k)
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  EXPECT_EQ(deformer->solves, 2) << "by a helper";
  organ->contactPoint.setValue({{0, 0, 0.7f}});
  EXPECT_NEAR(organ->deformedCoord.getValue()[1].z(), 0.7f, 1e-6f);
  EXPECT_EQ(deformer->reports, 2);
}

TEST_F(DeformableShape2Test, ADeformerMayBeReplacedAndTheShapeGoWhileTheyAreAtWork) {
  const InThreads all(2);
  deformer->modulus.setValue(1);
  for (int k = 0; k < 100; ++k) {
    organ->contactPoint.setValue({{0, 0, 0.01f * static_cast<float>(k)}});
    organ->begin();
    const auto next = context.make<Particular>();
    next->modulus.setValue(1);
    organ->deformer.setValue(next);
    deformer = nullptr;
    if (k % 2 == 0) {
      EXPECT_NEAR(organ->deformedCoord.getValue()[1].z(), 0.01f * static_cast<float>(k), 1e-6f);
    }
    deformer = next;
  }
  organ->contactPoint.setValue({{0, 0, 2}});
  organ->begin();
  organ = nullptr;
}

TEST_F(DeformableShape2Test, WhatThrowsBesideIsToldAndTheShapeStays) {
  const InThreads all(2);
  deformer->modulus.setValue(1);
  breathe(1);
  const std::vector<Vec3f> before = organ->deformedCoord.getValue();
  organ->contactPoint.setValue({{0, 0, std::numeric_limits<float>::quiet_NaN()}});
  organ->begin();
  EXPECT_EQ(organ->deformedCoord.getValue(), before);
  ASSERT_EQ(context.warnings.size(), 1u);
  EXPECT_THAT(context.warnings[0], ::testing::HasSubstr("not finite"));
}

TEST_F(DeformableShape2Test, ADeformerOfAnotherShapeIsRefusedUntilThatLetsItGo) {
  deformer->modulus.setValue(1);
  breathe(1);
  const auto second = triangle({{0, 0, 0.5f}});
  ASSERT_EQ(context.warnings.size(), 1u) << "though nobody looks";
  EXPECT_THAT(context.warnings[0], ::testing::HasSubstr("serves another shape"));
  EXPECT_EQ(second->deformedCoord.getValue(), second->origCoord.getValue());
  breathe(1);
  EXPECT_NEAR(organ->deformedCoord.getValue()[1].z(), 0.2f, 1e-6f);
  organ->deformer.setValue(nullptr);
  organ->deformedCoord.upToDate();
  second->origCoord.setValue({{0, 0, 1}, {1, 0, 1}, {0, 1, 1}});
  EXPECT_NEAR(second->deformedCoord.getValue()[1].z(), 1.5f, 1e-6f);
}

/// A ball of finite elements with inertia, pulled by its first point.
std::shared_ptr<DeformableShape2> movingBall(TestContext& context) {
  const TriangleMesh ball = icosphere(1, 0.05f);
  const auto points = context.make<Coordinate>([&](Coordinate& c) { c.point.setValue(ball.points); });
  const auto faces = context.make<IndexedFaceSet>([&](IndexedFaceSet& f) {
    std::vector<int> index;
    for (const Eigen::Vector3i& t : ball.triangles) index.insert(index.end(), {t[0], t[1], t[2], -1});
    f.coord.setValue(points);
    f.coordIndex.setValue(index);
  });
  return context.make<DeformableShape2>([&](DeformableShape2& shape) {
    shape.geometry.setValue(faces);
    shape.deformer.setValue(context.make<FiniteElementDeformer>([](FiniteElementDeformer& tissue) {
      tissue.model.setValue("LINEAR");
      tissue.elements.setValue(8);
      tissue.quasiStatic.setValue(false);
    }));
    shape.contactIndex.setValue({0, 3, 5, 9});
  });
}

TEST(DeformableShape2, AStepOfTimeThatWasBegunAndOvertakenIsNotLost) {
  const InThreads all(1);
  TestContext context;
  const auto straight = movingBall(context), overtaken = movingBall(context);
  const auto pulled = [&](float by) {
    std::vector<Vec3f> targets;
    for (const int i : {0, 3, 5, 9})
      targets.push_back(straight->origCoord.getValue()[static_cast<std::size_t>(i)] + Vec3f(by, 0, 0));
    return targets;
  };
  for (int k = 1; k <= 4; ++k) {
    context.tick(0.05 * k);
    overtaken->contactPoint.setValue(pulled(-0.01f));
    overtaken->begin();
    for (const auto& ball : {straight, overtaken}) ball->contactPoint.setValue(pulled(0.005f));
    EXPECT_EQ(overtaken->deformedCoord.getValue(), straight->deformedCoord.getValue()) << k;
  }
  EXPECT_NE(straight->deformedCoord.getValue()[1], straight->origCoord.getValue()[1]);
}

}  // namespace
}  // namespace pleura
