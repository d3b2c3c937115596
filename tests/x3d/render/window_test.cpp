#include <chrono>
#include <cstdlib>
#include <string>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

#include <pleura/x3d/browser/render/renderer.h>
#include <pleura/x3d/browser/render/window.h>

namespace pleura::render {
namespace {

bool runs(const std::string& command) { return std::system((command + " >/dev/null 2>&1").c_str()) == 0; }

TEST(Window, WithoutADisplayTheErrorSaysSo) {
  if (std::getenv("DISPLAY")) GTEST_SKIP() << "there is a display";
  try {
    const Window window(320, 240, "Pleura");
    ADD_FAILURE() << "a window without a display";
  } catch (const std::runtime_error& error) {
    EXPECT_NE(std::string(error.what()).find("DISPLAY"), std::string::npos) << error.what();
  }
}

class WindowOnDisplay : public ::testing::Test {
 protected:
  void SetUp() override {
    if (!std::getenv("DISPLAY")) GTEST_SKIP() << "no display; run under xvfb-run";
    window = std::make_unique<Window>(320, 240, "Pleura window test");
  }

  /// Polls until `done` or 10 seconds are over.
  template <class Condition>
  bool waitFor(const Condition& done) {
    const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(10);
    while (!done() && std::chrono::steady_clock::now() < end) {
      window->poll();
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
    return done();
  }

  std::unique_ptr<Window> window;
};

TEST_F(WindowOnDisplay, ShowsWhatTheRendererDraws) {
  DrawList list;
  list.background.skyColor = {{0, 1, 0.2f}};
  Renderer renderer(window->context());
  renderer.draw(list, window->size().x(), window->size().y());
  renderer.present();
  const GlFunctions gl = loadGlFunctions(window->context());
  std::uint8_t pixel[4] = {};
  gl.BindFramebuffer(GL_READ_FRAMEBUFFER, 0);
  gl.ReadPixels(160, 120, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, pixel);
  EXPECT_EQ(pixel[0], 0);
  EXPECT_EQ(pixel[1], 255);
  EXPECT_EQ(pixel[2], 51);
  window->swapBuffers();
}

TEST_F(WindowOnDisplay, DeliversKeysDragsAndWheel) {
  if (!runs("command -v xdotool")) GTEST_SKIP() << "no xdotool here";
  std::vector<KeyEvent> keys;
  std::vector<MouseButtonEvent> buttons;
  Eigen::Vector2f dragged(0, 0);
  float wheel = 0;
  window->events.key = [&](const KeyEvent& event) { keys.push_back(event); };
  window->events.mouseButton = [&](const MouseButtonEvent& event) { buttons.push_back(event); };
  window->events.mouseMove = [&](const MouseMoveEvent& event) {
    if (event.left) dragged += event.movement;
  };
  window->events.scroll = [&](float steps) { wheel += steps; };
  window->swapBuffers();
  window->poll();
  ASSERT_TRUE(runs("xdotool search --sync --name 'Pleura window test' windowfocus --sync"));
  runs("xdotool key shift+p");
  EXPECT_TRUE(waitFor([&] { return keys.size() >= 4; }));  // shift and P, down and up
  ASSERT_GE(keys.size(), 3u);
  EXPECT_EQ(keys[1].key, 'P');
  EXPECT_EQ(keys[1].action, Action::Press);
  EXPECT_TRUE(keys[1].modifiers.shift);
  EXPECT_EQ(keys[2].action, Action::Release);
  runs("xdotool search --name 'Pleura window test' mousemove --window %1 100 100");
  window->poll();
  runs("xdotool mousedown 1 mousemove_relative 30 20 mouseup 1 click 4");
  EXPECT_TRUE(waitFor([&] { return buttons.size() >= 2 && wheel > 0; }));
  EXPECT_NEAR(dragged.x(), 30, 1);
  EXPECT_NEAR(dragged.y(), 20, 1);
  EXPECT_EQ(wheel, 1);
}

TEST_F(WindowOnDisplay, ACallbacksExceptionComesOutOfPoll) {
  if (!runs("command -v xdotool")) GTEST_SKIP() << "no xdotool here";
  window->events.key = [](const KeyEvent&) { throw std::runtime_error("from the callback"); };
  window->swapBuffers();
  window->poll();
  ASSERT_TRUE(runs("xdotool search --sync --name 'Pleura window test' windowfocus --sync key a"));
  EXPECT_THROW(waitFor([] { return false; }), std::runtime_error);
}

}  // namespace
}  // namespace pleura::render
