#include <gtest/gtest.h>

#include <pleura/nodes/standard/navigation/navigation_info.h>
#include <pleura/nodes/standard/navigation/ortho_viewpoint.h>
#include <pleura/nodes/standard/navigation/viewpoint.h>
#include <pleura/tests/nodes/test_context.h>

namespace pleura {
namespace {

class Bindables : public ::testing::Test {
 protected:
  TestContext context;
};

TEST_F(Bindables, FirstOfItsKindIsBound) {
  context.tick(3);
  const auto first = context.make<Viewpoint>();
  const auto second = context.make<OrthoViewpoint>();
  const auto info = context.make<NavigationInfo>();
  EXPECT_TRUE(first->isBound.getValue());
  EXPECT_EQ(first->bindTime.getValue(), 3);
  EXPECT_FALSE(second->isBound.getValue());
  EXPECT_TRUE(info->isBound.getValue()) << "a stack of its own";
  EXPECT_EQ(context.bindables("Viewpoint").top(), first.get());
}

TEST_F(Bindables, BindingPushesAndUnbindingPops) {
  const auto a = context.make<Viewpoint>();
  const auto b = context.make<Viewpoint>();
  const auto c = context.make<Viewpoint>();
  b->set_bind.setValue(true);
  c->set_bind.setValue(true);
  EXPECT_EQ(context.bindables("Viewpoint").top(), c.get());
  EXPECT_FALSE(b->isBound.getValue());
  b->set_bind.setValue(false);
  EXPECT_EQ(context.bindables("Viewpoint").top(), c.get()) << "taken out from below";
  c->set_bind.setValue(false);
  EXPECT_FALSE(c->isBound.getValue());
  EXPECT_TRUE(a->isBound.getValue());
}

TEST_F(Bindables, BindingWhatIsBoundSendsNothing) {
  const auto a = context.make<Viewpoint>();
  Recorder<SFBool> sent(a->isBound);
  a->set_bind.setValue(true);
  EXPECT_TRUE(sent.values.empty());
}

TEST_F(Bindables, WhatIsDestroyedLeavesTheStack) {
  const auto a = context.make<Viewpoint>();
  auto b = context.make<Viewpoint>();
  b->set_bind.setValue(true);
  b.reset();
  EXPECT_TRUE(a->isBound.getValue());
  EXPECT_EQ(context.bindables("Viewpoint").top(), a.get());
}

}  // namespace
}  // namespace pleura
