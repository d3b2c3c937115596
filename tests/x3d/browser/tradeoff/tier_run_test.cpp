#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <pleura/tests/nodes/thorax/nodes/thorax_scene.h>
#include <pleura/x3d/browser/tradeoff/tier_run.h>

namespace pleura {
namespace {

using testing::UnorderedElementsAre;

/// Two moments of the first half of a breath.
class TierRunTest : public ::testing::Test {
 protected:
  TierRun run(const DeformationTier& tier) {
    const auto lung = std::find_if(breaths.begin(), breaths.end(),
                                   [](const OrganBreath& each) { return each.organ == "LUNG_L"; });
    return runTier(*scene, *lung, tier, [this](double done) { told.push_back(done); });
  }

  std::unique_ptr<Scene> scene = breathingThorax();
  std::vector<OrganBreath> breaths = recordBreath(*scene, 2, 2);
  std::vector<double> told;
};

TEST_F(TierRunTest, EveryOrganThatContactsHoldIsRecorded) {
  std::vector<std::string> organs;
  for (const OrganBreath& breath : breaths) {
    organs.push_back(breath.organ);
    ASSERT_EQ(breath.moments.size(), 2u);
    EXPECT_LT(breath.driven.size(), breath.rest.points.size());
    for (const auto& moment : breath.moments) {
      EXPECT_EQ(moment.targets.size(), breath.driven.size());
      EXPECT_EQ(moment.filled.size(), breath.rest.points.size());
    }
    EXPECT_NE(breath.moments[0].targets, breath.moments[1].targets);
  }
  EXPECT_THAT(organs, UnorderedElementsAre("LUNG_L", "LUNG_R", "DIAPHRAGM"));
}

TEST(OrganBreath, AnOrganThatTwoContactsHoldIsRecordedOnce) {
  const std::string held = "<DeformableShape2 USE='LUNG' containerField='organ'/></LungContacts>";
  const auto scene = sceneOf(
      "<ImportLibrary library='\"thorax\"'/><DeformableShape2 DEF='LUNG' origCoord='0 0 0 1 0 0 0 1 0'>"
      "<IndexedTriangleSet index='0 1 2'><Coordinate point='0 0 0 1 0 0 0 1 0'/></IndexedTriangleSet>"
      "</DeformableShape2><LungContacts DEF='FIRST'>" +
      held + "<LungContacts DEF='SECOND'>" + held);
  const std::vector<OrganBreath> breaths = recordBreath(*scene, 1, 1);
  ASSERT_EQ(breaths.size(), 1u);
  EXPECT_EQ(breaths[0].organ, "LUNG");
}

TEST_F(TierRunTest, ATierTakesTheDrivenPointsWhereTheyAreAskedAndTellsItsCost) {
  const TierRun linear = run(tierOf("linear FEM", 60));
  const OrganBreath& lung = *std::find_if(breaths.begin(), breaths.end(),
                                          [](const OrganBreath& each) { return each.organ == "LUNG_L"; });
  ASSERT_EQ(linear.shapes.size(), 2u);
  for (std::size_t k = 0; k < 2; ++k)
    for (std::size_t i = 0; i < lung.driven.size(); ++i)
      ASSERT_EQ(linear.shapes[k][static_cast<std::size_t>(lung.driven[i])], lung.moments[k].targets[i]);
  EXPECT_TRUE(linear.figures.converged);
  EXPECT_GT(linear.figures.median, 0);
  EXPECT_GE(linear.figures.p99, linear.figures.median);
  EXPECT_GT(linear.figures.setUp, 0);
#ifndef __SANITIZE_ADDRESS__  // its allocator tells nothing
  EXPECT_GT(linear.figures.memory, 1e5);
#endif
  EXPECT_EQ(told, (std::vector<double>{0.5, 1}));
}

TEST_F(TierRunTest, TheSmoothFillIsWhatTheContactsHaveAndCostsNothingMore) {
  const TierRun fill = run(tierOf("smooth fill", 0));
  EXPECT_EQ(fill.figures.median, 0);
  ASSERT_EQ(fill.shapes.size(), 2u);
  EXPECT_NE(fill.shapes[0], fill.shapes[1]);
}

TEST_F(TierRunTest, ADeformerThatThereIsNotIsRefused) {
  EXPECT_THROW(run({.method = "magic", .node = "MagicDeformer", .fields = {}, .elements = 0}),
               std::invalid_argument);
}

}  // namespace
}  // namespace pleura
