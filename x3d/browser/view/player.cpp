#include <algorithm>
#include <chrono>
#include <vector>

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <fmt/format.h>

#include <pleura/nodes/standard/grouping/x3d_bounded_object.h>
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

/// A field of the scene's BREATH; null where it has none.
template <class F>
F* breathField(Scene& scene, std::string_view name) {
  const auto& names = scene.document().names;
  const auto breath = names.find("BREATH");
  return breath == names.end() ? nullptr : dynamic_cast<F*>(breath->second->getField(name));
}

void nudge(SFFloat* field, float by, float least, float most) {
  if (field != nullptr) field->setValue(std::clamp(field->getValue() + by, least, most));
}

/// Appends the viewpoints at and below `node`, in the scene's order.
void collectViewpoints(const NodePtr& node, std::vector<X3DViewpointNode*>& found) {
  if (auto* viewpoint = dynamic_cast<X3DViewpointNode*>(node.get())) found.push_back(viewpoint);
  if (auto* object = dynamic_cast<X3DBoundedObject*>(node.get()))
    for (const auto& child : object->displayed()) collectViewpoints(child, found);
}

}  // namespace

Player::Player(Scene& scene, const TouchOptions& touch, int width, int height, const std::string& title)
    : scene_(scene),
      rate_(breathField<SFFloat>(scene, "rate")),
      depth_(breathField<SFFloat>(scene, "depth")),
      paused_(breathField<SFBool>(scene, "paused")),
      touch_(scene, touch, TouchSession::Clock::real),
      view_(scene),
      title_("Pleura - " + title),
      window_(width, height, title_),
      renderer_(window_.context()) {
  touch_.open();
  window_.events.key = [this](const auto& event) { onKey(event); };
  window_.events.character = [this](char32_t character) { onCharacter(character); };
  window_.events.mouseMove = [this](const auto& event) { onMove(event); };
  window_.events.scroll = [this](float steps) { camera().zoom(steps); };
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
      return nudge(rate_, -kRateStep, 0, 120);
    case GLFW_KEY_RIGHT:
      return nudge(rate_, kRateStep, 0, 120);
    case GLFW_KEY_DOWN:
      return nudge(depth_, -kDepthStep, 0, 1);
    case GLFW_KEY_UP:
      return nudge(depth_, kDepthStep, 0, 1);
    default:
      return;
  }
}

void Player::nextViewpoint(int step) {
  std::vector<X3DViewpointNode*> all;
  for (const auto& node : scene_.document().nodes) collectViewpoints(node, all);
  if (all.empty()) return;
  const auto isBound = [](X3DViewpointNode* viewpoint) { return viewpoint->isBound.getValue(); };
  const auto count = static_cast<int>(all.size());
  const auto bound = static_cast<int>(std::find_if(all.begin(), all.end(), isBound) - all.begin());
  all[static_cast<std::size_t>((bound + step + count) % count)]->set_bind.setValue(true);
  camera_.reset();
}

render::OrbitCamera& Player::camera() {
  if (!camera_) camera_.emplace(view_.viewpoint().camera, view_.viewpoint().centerOfRotation);
  return *camera_;
}

void Player::onMove(const render::MouseMoveEvent& event) {
  const auto size = window_.size();
  if (event.left) camera().orbit(event.movement.x(), event.movement.y(), size.y());
  if (event.right || event.middle) camera().pan(event.movement.x(), event.movement.y(), size.x(), size.y());
}

void Player::drawFrame() {
  view_.lookThrough(camera_ ? std::optional(camera_->camera()) : std::nullopt);
  auto& list = view_.update();
  const auto size = window_.size();
  if (size.x() < 1 || size.y() < 1) return;
  renderer_.draw(list, size.x(), size.y());
  renderer_.present();
  window_.swapBuffers();
}

void Player::showBreath() {
  if (rate_ == nullptr || depth_ == nullptr || paused_ == nullptr) return;
  std::string breath = fmt::format(" - {:.3g} breaths/min, depth {:.2f}{}", rate_->getValue(),
                                   depth_->getValue(), paused_->getValue() ? ", paused" : "");
  if (breath == breath_) return;
  breath_ = std::move(breath);
  window_.setTitle(title_ + breath_);
}

void Player::run(double seconds) {
  const auto start = std::chrono::steady_clock::now();
  const auto now = [&] {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  };
  while (!window_.closeRequested() && (seconds <= 0 || now() < seconds)) {
    const double time = now();
    scene_.tick(time);
    touch_.advance(time);
    drawFrame();
    showBreath();
    window_.poll();
  }
}

}  // namespace pleura
