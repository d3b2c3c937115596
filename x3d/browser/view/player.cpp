#include <algorithm>
#include <cmath>
#include <vector>

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <pleura/x3d/browser/view/player.h>

namespace pleura {

namespace {

std::string utf8(char32_t c) {
  std::string text;
  if (c < 0x80) return {static_cast<char>(c)};
  if (c >= 0x10000) text += static_cast<char>(0xF0 | (c >> 18));
  if (c >= 0x800)
    text += static_cast<char>((c >= 0x10000 ? 0x80 : 0xE0) | ((c >> 12) & (c >= 0x10000 ? 0x3F : 0x0F)));
  text += static_cast<char>((c >= 0x800 ? 0x80 : 0xC0) | ((c >> 6) & (c >= 0x800 ? 0x3F : 0x1F)));
  return text + static_cast<char>(0x80 | (c & 0x3F));
}

/// X3D's number of an action key (ISO/IEC 19775-1, table 21.3); 0 for any other key.
int actionKeyOf(int key) {
  if (key >= GLFW_KEY_F1 && key <= GLFW_KEY_F12) return key - GLFW_KEY_F1 + 1;
  constexpr int kFromHome[] = {GLFW_KEY_HOME, GLFW_KEY_END,  GLFW_KEY_PAGE_UP, GLFW_KEY_PAGE_DOWN,
                               GLFW_KEY_UP,   GLFW_KEY_DOWN, GLFW_KEY_LEFT,    GLFW_KEY_RIGHT};
  const auto* found = std::find(std::begin(kFromHome), std::end(kFromHome), key);
  return found == std::end(kFromHome) ? 0 : 13 + static_cast<int>(found - std::begin(kFromHome));
}

/// Adds to a number of BREATH, where there is one, within `least` and `most`.
void nudge(Scene& scene, std::string_view path, float by, float least, float most) {
  try {
    if (auto* field = dynamic_cast<SFFloat*>(&scene.field(path)))
      field->setValue(std::clamp(field->getValue() + by, least, most));
  } catch (const UnknownNameError&) {
    return;  // a scene without a breath has nothing to steer
  }
}

}  // namespace

Player::Player(Scene& scene, int width, int height, const std::string& title)
    : scene_(scene), view_(scene), window_(width, height, "Pleura - " + title), renderer_(window_.context()) {
  window_.events.key = [this](const auto& event) { onKey(event); };
  window_.events.character = [this](char32_t character) { onCharacter(character); };
  window_.events.mouseMove = [this](const auto& event) { onMove(event); };
  window_.events.scroll = [this](float steps) {
    if (camera_) camera_->zoom(steps);
  };
}

void Player::onCharacter(char32_t character) {
  KeyEvent event{.character = utf8(character)};
  scene_.key(event);
  event.pressed = false;
  scene_.key(event);
}

void Player::onKey(const render::KeyEvent& event) {
  const bool isPressed = event.action != render::Action::Release;
  if (const int action = actionKeyOf(event.key); action != 0)
    scene_.key({.kind = KeyEvent::Kind::action, .pressed = isPressed, .character = {}, .action = action});
  if (isPressed) steer(event.key);
}

void Player::steer(int key) {
  constexpr float kRateStep = 1;          // [1/min]
  constexpr float kDepthStep = 1.f / 28;  // a quarter of a quiet breath
  switch (key) {
    case GLFW_KEY_ESCAPE:
      return window_.requestClose();
    case GLFW_KEY_HOME:
      return camera_.reset();
    case GLFW_KEY_PAGE_UP:
      return nextViewpoint(-1);
    case GLFW_KEY_PAGE_DOWN:
      return nextViewpoint(1);
    case GLFW_KEY_LEFT:
      return nudge(scene_, "BREATH.rate", -kRateStep, 0, 120);
    case GLFW_KEY_RIGHT:
      return nudge(scene_, "BREATH.rate", kRateStep, 0, 120);
    case GLFW_KEY_DOWN:
      return nudge(scene_, "BREATH.depth", -kDepthStep, 0, 1);
    case GLFW_KEY_UP:
      return nudge(scene_, "BREATH.depth", kDepthStep, 0, 1);
    default:
      return;
  }
}

void Player::nextViewpoint(int step) {
  std::vector<std::string> names;
  for (const auto& [name, node] : scene_.document().names)
    if (dynamic_cast<X3DViewpointNode*>(node.get()) != nullptr) names.push_back(name);
  if (names.empty()) return;
  const int count = static_cast<int>(names.size());
  viewpoint_ = (viewpoint_ + step + count) % count;
  view_.lookFrom(names[static_cast<std::size_t>(viewpoint_)]);
  camera_.reset();
}

void Player::onMove(const render::MouseMoveEvent& event) {
  if (!camera_) return;
  const auto size = window_.size();
  if (event.left) camera_->orbit(event.movement.x(), event.movement.y(), size.y());
  if (event.right || event.middle) camera_->pan(event.movement.x(), event.movement.y(), size.x(), size.y());
}

void Player::drawFrame() {
  if (camera_) {
    view_.lookThrough(camera_->camera());
  } else {
    view_.lookThrough(std::nullopt);
  }
  auto& list = view_.update();
  if (!camera_) camera_.emplace(view_.viewpoint().camera, view_.viewpoint().centerOfRotation);
  const auto size = window_.size();
  if (size.x() < 1 || size.y() < 1) return;
  renderer_.draw(list, size.x(), size.y());
  renderer_.present();
  window_.swapBuffers();
}

void Player::run(double seconds) {
  const auto start = std::chrono::steady_clock::now();
  const auto now = [&] {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  };
  while (!window_.closeRequested() && (seconds <= 0 || now() < seconds)) {
    window_.poll();
    scene_.tick(now());
    drawFrame();
  }
}

}  // namespace pleura
