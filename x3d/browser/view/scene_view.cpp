#include <stdexcept>
#include <vector>

#include <fmt/format.h>

#include <pleura/fields/nearest_name.h>
#include <pleura/nodes/haptic/device_info.h>
#include <pleura/nodes/standard/environmental_effects/background.h>
#include <pleura/nodes/standard/navigation/lod.h>
#include <pleura/nodes/standard/navigation/navigation_info.h>
#include <pleura/x3d/browser/render/validate.h>
#include <pleura/x3d/browser/scene/traversal.h>
#include <pleura/x3d/browser/view/billboard_turn.h>
#include <pleura/x3d/browser/view/light.h>
#include <pleura/x3d/browser/view/scene_view.h>
#include <pleura/x3d/browser/view/surface.h>
#include <pleura/x3d/browser/view/text_style.h>

namespace pleura {

namespace {

template <class T>
T* bound(Scene& scene, std::string_view kind) {
  return dynamic_cast<T*>(scene.bindables(kind).top());
}

}  // namespace

void SceneView::lookFrom(std::string_view viewpoint) {
  std::vector<std::string_view> known;
  for (const auto& [name, node] : scene_.document().names) {
    if (dynamic_cast<X3DViewpointNode*>(node.get()) == nullptr) continue;
    if (name == viewpoint) return void(chosenViewpoint_ = node.get());
    known.push_back(name);
  }
  throw std::invalid_argument(
      fmt::format("the scene has no viewpoint {}{}", viewpoint, didYouMean(nearestName(viewpoint, known))));
}

render::DrawList& SceneView::update() {
  ++frame_;
  findBound();
  list_.items.clear();
  list_.lights.clear();
  list_.overlay.clear();
  globalLights_ = 0;
  setCamera();  // which billboards and levels of detail look at; its depth range waits for the new box
  box_.setEmpty();
  seen_.clear();
  visitAll(scene_.document().nodes, Matrix4f::Identity(), 0);
  for (const Seen& one : seen_) one.shape->begin();
  for (const Seen& one : seen_) addShape(one);
  for (auto& item : list_.items) item.lights |= globalLights_;
  std::erase_if(drawn_, [&](const auto& each) { return each.second.frame != frame_; });
  setCamera();
  setBackground();
  auto* navigation = bound<NavigationInfo>(scene_, "NavigationInfo");
  list_.headlight = navigation == nullptr || navigation->headlight.getValue();
  return list_;
}

template <class Drawable>
bool SceneView::isDrawable(const Node& node, const Drawable& drawable) {
  try {
    render::validate(drawable);
  } catch (const std::invalid_argument& bad) {
    scene_.warn(node, std::string(bad.what()) + ": not drawn");
    return false;
  }
  return true;
}

void SceneView::findBound() {
  boundViewpoint_ =
      chosenViewpoint_ != nullptr ? chosenViewpoint_ : bound<X3DViewpointNode>(scene_, "Viewpoint");
  boundBackground_ = bound<X3DBackgroundNode>(scene_, "Background");
  viewpointToWorld_ = backgroundToWorld_ = Matrix4f::Identity();
  for (const auto& node : scene_.document().nodes) locate(node, Matrix4f::Identity());
}

void SceneView::locate(const NodePtr& node, const Matrix4f& toWorld) {
  if (!node) return;
  if (node.get() == boundViewpoint_) viewpointToWorld_ = toWorld;
  if (node.get() == boundBackground_) backgroundToWorld_ = toWorld;
  const auto children = inside(*node);
  if (children.empty()) return;
  const Matrix4f below = placed(*node, toWorld);
  for (const auto& child : children) locate(child, below);
}

std::uint32_t SceneView::lightsAmong(std::span<const NodePtr> nodes, const Matrix4f& toWorld) {
  std::uint32_t mask = 0;
  for (const auto& node : nodes) {
    auto* light = dynamic_cast<X3DLightNode*>(node.get());
    if (light == nullptr || list_.lights.size() >= render::maxLights) continue;
    const auto on = placedLight(*light, toWorld);
    if (!on || !isDrawable(*light, on->light)) continue;
    const std::uint32_t bit = 1u << list_.lights.size();
    (on->isGlobal ? globalLights_ : mask) |= bit;
    list_.lights.push_back(on->light);
  }
  return mask;
}

void SceneView::visitAll(std::span<const NodePtr> nodes, const Matrix4f& toWorld, std::uint32_t lights) {
  lights |= lightsAmong(nodes, toWorld);
  for (const auto& node : nodes)
    if (node) visit(node, toWorld, lights);
}

void SceneView::visit(const NodePtr& node, const Matrix4f& toWorld, std::uint32_t lights) {
  if (auto* shape = dynamic_cast<X3DShapeNode*>(node.get())) {
    if (shape->visible.getValue()) seen_.push_back({shape, toWorld, lights});
    return;
  }
  if (auto* info = dynamic_cast<DeviceInfo*>(node.get())) return visitStyli(*info, lights);
  if (auto* levels = dynamic_cast<LOD*>(node.get())) levels->seeFrom(viewerIn(list_.camera.view * toWorld));
  const auto children = inside(*node);
  if (children.empty()) return;
  Matrix4f below = placed(*node, toWorld);
  if (auto* billboard = dynamic_cast<Billboard*>(node.get()))
    below = toWorld * billboardTurn(*billboard, toWorld, list_.camera.view);
  visitAll(children, below, lights);
}

void SceneView::visitStyli(DeviceInfo& info, std::uint32_t lights) {
  if (!info.isBound.getValue()) return;
  for (const auto& node : info.device.getValue()) {
    auto* device = dynamic_cast<HapticsDeviceNode*>(node.get());
    if (device == nullptr || !device->stylus.getValue() || !device->isConnected.getValue()) continue;
    Eigen::Affine3f toWorld = Eigen::Affine3f::Identity();
    toWorld.translate(device->tipPosition.getValue());
    toWorld.rotate(device->trackerOrientation.getValue().quaternion());
    visit(device->stylus.getValue(), toWorld.matrix(), lights);
  }
}

void SceneView::addShape(const Seen& one) {
  const auto& [node, toWorld, lights] = one;
  X3DShapeNode& shape = *node;
  render::Geometry* geometry = geometryOf(shape.geometry.getValue());
  if (geometry == nullptr || geometry->indices.empty()) return;
  const Surface surface = surfaceOf(shape);
  const render::DrawItem item{geometry, toWorld, surface.material, lights, surface.size};
  if (!isDrawable(shape, item)) return;
  list_.items.push_back(item);
  for (const auto& p : geometry->positions)
    if (const Vec3f inWorld = toWorld.topLeftCorner<3, 3>() * p + toWorld.topRightCorner<3, 1>();
        inWorld.allFinite())
      box_.extend(inWorld);
}

render::Geometry* SceneView::geometryOf(const NodePtr& node) {
  auto* geometry = dynamic_cast<X3DGeometryNode*>(node.get());
  if (geometry == nullptr) return nullptr;
  Drawn& drawn = drawn_[node.get()];
  drawn.keepAlive = node;
  drawn.frame = frame_;
  auto& out = drawn.geometry;
  const auto revisions = [&] { return std::pair(out.positionsRevision, out.indicesRevision); };
  const auto before = revisions();
  if (auto* text = dynamic_cast<Text*>(geometry)) {
    updateText(drawn, *text);
  } else {
    updateMesh(out, geometry->renderMesh());
  }
  if (revisions() != before) drawn.isSound = isDrawable(*node, out);
  return drawn.isSound ? &out : nullptr;
}

void SceneView::updateMesh(render::Geometry& out, const RenderMesh& mesh) {
  out.primitive = mesh.primitive == RenderMesh::Primitive::triangles ? render::Primitive::Triangles
                  : mesh.primitive == RenderMesh::Primitive::lines   ? render::Primitive::Lines
                                                                     : render::Primitive::Points;
  out.positions = mesh.positions;
  out.normals = mesh.normals;
  out.colors = mesh.colors;
  out.indices = mesh.indices;
  out.solid = mesh.solid;
  out.ccw = mesh.ccw;
  out.positionsRevision = out.normalsRevision = out.colorsRevision = mesh.vertexRevision;
  out.indicesRevision = mesh.topologyRevision;
}

void SceneView::updateText(Drawn& drawn, Text& text) {
  const std::uint64_t stamp = textStamp(text);
  if (stamp == drawn.textStamp) return;
  drawn.textStamp = stamp;
  drawn.text = layOut(text);
  auto& out = drawn.geometry;
  out.positions = drawn.text.positions;
  out.indices = drawn.text.indices;
  out.solid = text.solid.getValue();
  out.positionsRevision = out.indicesRevision = stamp;
}

void SceneView::setCamera() {
  auto* node = dynamic_cast<X3DViewpointNode*>(boundViewpoint_);
  viewpoint_ = node != nullptr ? placedCamera(*node, viewpointToWorld_, box_) : cameraFor(box_);
  if (node != nullptr && !isDrawable(*node, viewpoint_.camera)) viewpoint_ = PlacedCamera();
  list_.camera = override_.value_or(viewpoint_.camera);
}

void SceneView::setBackground() {
  auto* node = dynamic_cast<X3DBackgroundNode*>(boundBackground_);
  if (node == nullptr) {
    static const render::Background black;
    list_.background = black;
    return;
  }
  list_.background.skyColor = node->skyColor.getValue();
  list_.background.skyAngle = node->skyAngle.getValue();
  list_.background.groundColor = node->groundColor.getValue();
  list_.background.groundAngle = node->groundAngle.getValue();
  if (list_.background.skyColor.empty()) list_.background.skyColor = {RGB::Zero()};
  const Eigen::Affine3f toWorld(backgroundToWorld_);
  list_.background.rotation = toWorld.rotation();
  if (!isDrawable(*node, list_.background)) list_.background = {};
}

}  // namespace pleura
