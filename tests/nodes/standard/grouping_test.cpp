#include <random>

#include <gtest/gtest.h>

#include <pleura/nodes/standard/grouping/group.h>
#include <pleura/nodes/standard/grouping/switch.h>
#include <pleura/nodes/standard/grouping/transform.h>
#include <pleura/tests/nodes/test_context.h>

namespace pleura {
namespace {

TEST(Group, AddsEachChildOnceAndRemovesIt) {
  TestContext context;
  const auto group = context.make<Group>();
  const NodePtr a = create<Group>(), b = create<Group>();
  group->addChildren.setValue({a, b, a});
  EXPECT_EQ(group->children.getValue(), (std::vector<NodePtr>{a, b}));
  Recorder<MFNode> changes(group->children);
  group->addChildren.setValue({b});
  EXPECT_TRUE(changes.values.empty()) << "what is there already changes nothing";
  group->removeChildren.setValue({a});
  EXPECT_EQ(group->children.getValue(), std::vector<NodePtr>{b});
  group->removeChildren.setValue({a});
  EXPECT_EQ(changes.values.size(), 1u);
}

TEST(Group, AddsWhatARouteSends) {
  TestContext context;
  const auto group = context.make<Group>();
  MFNode source;
  source.setValue({create<Group>()});
  source.route(group->addChildren);
  EXPECT_EQ(group->children.size(), 1u);
}

TEST(Group, ShowsNothingWhenNotVisible) {
  TestContext context;
  const auto group = context.make<Group>();
  group->children.setValue({create<Group>()});
  EXPECT_EQ(group->displayed().size(), 1u);
  group->visible.setValue(false);
  EXPECT_TRUE(group->displayed().empty());
}

TEST(Switch, ShowsTheChosenChildOnly) {
  TestContext context;
  const auto node = context.make<Switch>();
  const NodePtr a = create<Group>(), b = create<Group>();
  node->children.setValue({a, b});
  for (const int choice : {-1, 2, 1 << 30}) {
    node->whichChoice.setValue(choice);
    EXPECT_TRUE(node->displayed().empty()) << choice;
  }
  node->whichChoice.setValue(1);
  ASSERT_EQ(node->displayed().size(), 1u);
  EXPECT_EQ(node->displayed()[0], b);
}

Eigen::Affine3d translation(const Vec3f& by) {
  return Eigen::Affine3d(Eigen::Translation3d(by.cast<double>()));
}

Eigen::Affine3d turn(const Rotation& by) { return Eigen::Affine3d(by.quaternion().cast<double>()); }

TEST(Transform, FollowsTheFormulaOfTheStandard) {
  std::mt19937 random(7);
  std::uniform_real_distribution<float> number(-2, 2);
  const auto vector = [&] { return Vec3f(number(random), number(random), number(random)); };
  for (int i = 0; i < 50; ++i) {
    const auto node = create<Transform>();
    const Vec3f T = vector(), C = vector(), S = vector();
    const Rotation R(vector(), number(random)), SR(vector(), number(random));
    node->translation.setValue(T);
    node->center.setValue(C);
    node->scale.setValue(S);
    node->rotation.setValue(R);
    node->scaleOrientation.setValue(SR);
    Eigen::Affine3d expected = translation(T) * translation(C) * turn(R) * turn(SR);
    expected.scale(S.cast<double>());
    expected = expected * turn(SR).inverse() * translation(-C);
    EXPECT_LT((node->matrix.getValue().cast<double>() - expected.matrix()).norm(), 2e-5);
  }
}

TEST(Transform, IsOneMatrixPerChangeAndOnlyWhenRead) {
  const auto node = create<Transform>();
  EXPECT_TRUE(node->matrix.getValue().isIdentity());
  node->translation.setValue({1, 0, 0});
  node->rotation.setValue({0, 1, 0, 1});
  EXPECT_FALSE(node->matrix.isUpToDate());
  const auto stamp = node->matrix.getStamp();
  node->matrix.getValue();
  EXPECT_TRUE(node->matrix.isUpToDate());
  EXPECT_EQ(node->matrix.getStamp(), stamp);
}

}  // namespace
}  // namespace pleura
