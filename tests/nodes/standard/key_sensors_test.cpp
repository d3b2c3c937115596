#include <gtest/gtest.h>

#include <pleura/nodes/standard/keydevicesensor/action_keys.h>
#include <pleura/nodes/standard/keydevicesensor/key_sensor.h>
#include <pleura/nodes/standard/keydevicesensor/string_sensor.h>
#include <pleura/tests/nodes/test_context.h>

namespace pleura {
namespace {

using Kind = KeyEvent::Kind;

class KeySensors : public ::testing::Test {
 protected:
  void type(const std::string& character) {
    context.key({Kind::character, true, character, 0});
    context.key({Kind::character, false, character, 0});
  }
  void modifier(Kind kind, bool pressed) { context.key({kind, pressed, "", 0}); }
  TestContext context;
};

TEST_F(KeySensors, TellWhichKeyWentDownAndUp) {
  const auto node = context.make<KeySensor>();
  Recorder<SFString> presses(node->keyPress), releases(node->keyRelease);
  context.key({Kind::character, true, "p", 0});
  EXPECT_TRUE(node->isActive.getValue());
  context.key({Kind::character, false, "p", 0});
  EXPECT_FALSE(node->isActive.getValue());
  type("p");
  EXPECT_EQ(presses.values, (std::vector<std::string>{"p", "p"}));
  EXPECT_EQ(releases.values, (std::vector<std::string>{"p", "p"}));
  context.key({Kind::action, true, "", static_cast<int>(ActionKey::home)});
  EXPECT_EQ(node->actionKeyPress.getValue(), 13);
  EXPECT_EQ(node->actionKeyRelease.getValue(), 0);
  modifier(Kind::shift, true);
  modifier(Kind::control, true);
  modifier(Kind::shift, false);
  EXPECT_FALSE(node->shiftKey.getValue());
  EXPECT_TRUE(node->controlKey.getValue());
  EXPECT_FALSE(node->altKey.getValue());
}

TEST_F(KeySensors, HearNothingWhileDisabledOrGone) {
  auto node = context.make<KeySensor>();
  context.key({Kind::character, true, "a", 0});
  node->enabled.setValue(false);
  EXPECT_FALSE(node->isActive.getValue());
  Recorder<SFString> presses(node->keyPress);
  type("b");
  EXPECT_TRUE(presses.values.empty());
  node.reset();
  type("c");
}

TEST_F(KeySensors, StringIsBuiltUntilEnter) {
  const auto node = context.make<StringSensor>();
  for (const auto* character : {"a", "\xC3\xBC", "b", "\b"}) type(character);
  EXPECT_EQ(node->enteredText.getValue(), "a\xC3\xBC");
  EXPECT_TRUE(node->isActive.getValue());
  type("\b");
  EXPECT_EQ(node->enteredText.getValue(), "a") << "a character is taken back whole";
  node->deletionAllowed.setValue(false);
  type("\b");
  type("\r");
  EXPECT_EQ(node->finalText.getValue(), "a");
  EXPECT_EQ(node->enteredText.getValue(), "");
  EXPECT_FALSE(node->isActive.getValue());
}

}  // namespace
}  // namespace pleura
