#include <gtest/gtest.h>

#include <pleura/nodes/standard/eventutilities/boolean_filter.h>
#include <pleura/nodes/standard/eventutilities/boolean_sequencer.h>
#include <pleura/nodes/standard/eventutilities/boolean_toggle.h>
#include <pleura/nodes/standard/eventutilities/boolean_trigger.h>
#include <pleura/nodes/standard/eventutilities/integer_sequencer.h>
#include <pleura/nodes/standard/eventutilities/integer_trigger.h>
#include <pleura/nodes/standard/eventutilities/time_trigger.h>
#include <pleura/tests/nodes/test_context.h>

namespace pleura {
namespace {

class EventUtilities : public ::testing::Test {
 protected:
  TestContext context;
};

TEST_F(EventUtilities, FilterSortsTrueFromFalse) {
  const auto node = context.make<BooleanFilter>();
  Recorder<SFBool> yes(node->inputTrue), no(node->inputFalse), negated(node->inputNegate);
  for (const bool value : {true, false, false}) node->set_boolean.setValue(value);
  EXPECT_EQ(yes.values, std::vector<bool>{true});
  EXPECT_EQ(no.values, (std::vector<bool>{false, false}));
  EXPECT_EQ(negated.values, (std::vector<bool>{false, true, true}));
}

TEST_F(EventUtilities, ToggleTurnsOverWithEveryTrue) {
  const auto node = context.make<BooleanToggle>();
  Recorder<SFBool> toggled(node->toggle);
  for (const bool value : {true, false, true, true}) node->set_boolean.setValue(value);
  EXPECT_EQ(toggled.values, (std::vector<bool>{true, false, true}));
}

TEST_F(EventUtilities, TriggersSendForEveryEvent) {
  context.tick(12.5);
  const auto boolean = context.make<BooleanTrigger>();
  const auto integer = context.make<IntegerTrigger>();
  const auto time = context.make<TimeTrigger>();
  integer->integerKey.setValue(42);
  Recorder<SFBool> booleans(boolean->triggerTrue);
  Recorder<SFInt32> integers(integer->triggerValue);
  Recorder<SFTime> times(time->triggerTime);
  boolean->set_triggerTime.setValue(3);
  boolean->set_triggerTime.setValue(3);
  for (const bool value : {true, false, true}) {
    integer->set_boolean.setValue(value);
    time->set_boolean.setValue(value);
  }
  EXPECT_EQ(booleans.values, (std::vector<bool>{true, true}));
  EXPECT_EQ(integers.values, (std::vector<std::int32_t>{42, 42}));
  EXPECT_EQ(times.values, (std::vector<Time>{12.5, 12.5, 12.5}));
}

TEST_F(EventUtilities, ActOnWhatRoutesSendThroughAChain) {
  const auto filter = context.make<BooleanFilter>();
  const auto toggle = context.make<BooleanToggle>();
  const auto time = context.make<TimeTrigger>();
  filter->inputTrue.routeNoEvent(toggle->set_boolean);
  toggle->toggle.routeNoEvent(time->set_boolean);
  context.tick(2);
  filter->set_boolean.setValue(true);
  EXPECT_TRUE(toggle->toggle.getValue());
  EXPECT_EQ(time->triggerTime.getValue(), 2);
}

TEST_F(EventUtilities, SequencerSendsWhenTheKeyChanges) {
  const auto node = context.make<IntegerSequencer>();
  node->key.setValue({0, 0.5f, 0.75f});
  node->keyValue.setValue({10, 20, 30});
  Recorder<SFInt32> sent(node->value_changed);
  for (const float f : {0.1f, 0.2f, 0.5f, 0.6f, 0.9f, 0.0f}) node->set_fraction.setValue(f);
  EXPECT_EQ(sent.values, (std::vector<std::int32_t>{10, 20, 30, 10}));
}

TEST_F(EventUtilities, SequencerStepsAroundTheEnds) {
  const auto node = context.make<BooleanSequencer>();
  node->key.setValue({0, 0.5f, 1});
  node->keyValue.setValue({true, false, false});
  Recorder<SFBool> sent(node->value_changed);
  node->previous.setValue(true);
  node->next.setValue(true);
  node->next.setValue(false);
  node->next.setValue(true);
  EXPECT_EQ(sent.values, (std::vector<bool>{false, true, false}));
  node->key.clear();
  node->next.setValue(true);
  EXPECT_EQ(sent.values.size(), 3u) << "no keys, no values";
}

}  // namespace
}  // namespace pleura
