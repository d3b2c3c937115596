#include <cmath>
#include <stdexcept>

#include <fmt/format.h>

#include <pleura/haptics/servo/servo_report.h>
#include <pleura/nodes/standard/core/metadata_string.h>
#include <pleura/nodes/standard/rendering/x3d_composed_geometry_node.h>
#include <pleura/nodes/standard/shape/appearance.h>
#include <pleura/x3d/browser/scene/traversal.h>
#include <pleura/x3d/browser/touch/touch_scene.h>

namespace pleura {

namespace {

HapticSurfaceNode* surfaceOf(X3DShapeNode& shape) {
  auto* appearance = dynamic_cast<Appearance*>(shape.appearance.get());
  return appearance != nullptr ? dynamic_cast<HapticSurfaceNode*>(appearance->surface.get()) : nullptr;
}

/// A = R S: the rotation R, and S, which is the identity for a rigid A.
struct RigidAndStretch {
  Eigen::Isometry3d rigid;
  Eigen::Matrix3f stretch;
};

RigidAndStretch split(const Matrix4f& toWorld) {
  const Eigen::Matrix3f a = toWorld.topLeftCorner<3, 3>();
  const Eigen::Matrix3f rotation = Eigen::Affine3f(toWorld).rotation();
  const Eigen::Matrix3f stretch = rotation.transpose() * a;
  Eigen::Isometry3d rigid = Eigen::Isometry3d::Identity();
  rigid.linear() = Eigen::Quaterniond(rotation.cast<double>()).normalized().toRotationMatrix();
  rigid.translation() = toWorld.topRightCorner<3, 1>().cast<double>();
  constexpr float kRounding = 1e-5f;
  const bool isRigid = (stretch - Eigen::Matrix3f::Identity()).cwiseAbs().maxCoeff() < kRounding;
  return {rigid, isRigid ? Eigen::Matrix3f(Eigen::Matrix3f::Identity()) : stretch};
}

/// The node's title: the text of a MetadataString of that name. Null where it has none.
const std::string* titleOf(Node& node) {
  auto* metadata = dynamic_cast<MetadataString*>(node.metadata.getValue().get());
  if (metadata == nullptr || metadata->name.getValue() != "title" || metadata->value.empty()) return nullptr;
  return &metadata->value.getValue().front();
}

}  // namespace

void TouchScene::update() {
  for (auto& [shape, places] : placesSeen_) places = 0;
  effects_.clear();
  for (Part& part : parts_) part.geometry = nullptr;
  for (const auto& node : scene_.document().nodes)
    if (node) visit(node, Matrix4f::Identity(), {});
  const auto isThere = [](const Part& part) { return part.geometry != nullptr; };
  for (const Part& part : parts_)
    if (isThere(part)) part.shape->begin();
  for (std::size_t id = 0; id < parts_.size(); ++id)
    if (isThere(parts_[id])) updateSurface(parts_[id], surfaces_[id]);
}

void TouchScene::visit(const NodePtr& node, const Matrix4f& toWorld, const Called& around) {
  Called own;
  const std::string* title = titleOf(*node);
  if (!node->getName().empty() || title != nullptr)
    own = {node->getName(), title != nullptr ? *title : node->getName()};
  const Called& called = own.title.empty() ? around : own;
  if (auto* shape = dynamic_cast<X3DShapeNode*>(node.get())) {
    if (shape->visible.getValue()) addPart(node, *shape, toWorld, called);
    return;
  }
  if (auto* effect = dynamic_cast<ForceEffectNode*>(node.get())) {
    addEffect(node, *effect, toWorld);
    return;
  }
  if (dynamic_cast<Bindable*>(node.get()) == scene_.bindables("Viewpoint").top()) viewpointToWorld_ = toWorld;
  const auto children = inside(*node);
  if (children.empty()) return;
  const Matrix4f below = placed(*node, toWorld);
  for (const auto& child : children)
    if (child) visit(child, below, called);
}

void TouchScene::addEffect(const NodePtr& node, ForceEffectNode& effect, const Matrix4f& toWorld) {
  auto force = effect.effect(toWorld);
  if (!force) return;
  if (effects_.size() == haptics::ServoReport::kMaxEffects)
    return scene_.warn(effect, fmt::format("no more than {} forces act at once", effects_.size()));
  force->id = effectIds_.try_emplace(node.get(), static_cast<std::uint32_t>(effectIds_.size())).first->second;
  effects_.push_back({node, &effect, *force});
}

void TouchScene::addPart(const NodePtr& node, X3DShapeNode& shape, const Matrix4f& toWorld,
                         const Called& called) {
  HapticSurfaceNode* surface = surfaceOf(shape);
  X3DGeometryNode* geometry = shape.geometry.get();
  if (surface == nullptr || geometry == nullptr || !toWorld.allFinite()) return;
  auto& ids = idsOf_[node.get()];
  const std::size_t place = placesSeen_[node.get()]++;
  if (place == ids.size()) {
    ids.push_back(static_cast<std::uint32_t>(parts_.size()));
    parts_.emplace_back();
    surfaces_.emplace_back();
  }
  Part& part = parts_[ids[place]];
  if (part.keepAlive != node) part.keepAlive = node;
  part.shape = &shape;
  part.geometry = geometry;
  part.surface = surface;
  if (part.called != called) part.called = called;
  part.toWorld = toWorld;
}

void TouchScene::updateSurface(const Part& part, Surface& surface) {
  bool isStretched = false;
  if (part.toWorld != surface.toWorld) {
    const auto [rigid, stretch] = split(part.toWorld);
    isStretched = stretch != surface.stretch;
    surface.pose = rigid;
    surface.stretch = stretch;
    surface.toWorld = part.toWorld;
  }
  std::span<const Vec3f> points;
  std::array<std::uint64_t, 2> source{};
  auto* touchable = dynamic_cast<TouchableShape*>(part.shape);
  std::span<const Eigen::Vector3i> triangles;
  if (touchable != nullptr) {
    auto* composed = dynamic_cast<X3DComposedGeometryNode*>(part.geometry);
    surface.isTwoSided = composed != nullptr && !composed->solid.getValue();
    points = touchable->untouchedPoints().getValue();
    triangles = touchable->untouchedTriangles();
    source = {triangles.size(), touchable->untouchedPoints().getStamp()};
  } else {
    const RenderMesh& mesh = part.geometry->renderMesh();
    if (mesh.primitive != RenderMesh::Primitive::triangles) return;
    surface.isTwoSided = !mesh.solid;
    points = mesh.positions;
    source = {mesh.topologyRevision, mesh.vertexRevision};
    if (surface.source[0] != source[0]) {
      triangles_.resize(mesh.indices.size() / 3);
      for (std::size_t t = 0; t < triangles_.size(); ++t) {
        const auto corner = [&](std::size_t k) { return static_cast<int>(mesh.indices[3 * t + k]); };
        triangles_[t] = {corner(0), corner(1), corner(2)};
        if (!mesh.ccw) std::swap(triangles_[t][1], triangles_[t][2]);
      }
    }
    triangles = triangles_;
  }
  if (source == surface.source && !isStretched) return;
  if (surface.stretch != Eigen::Matrix3f::Identity()) {
    moved_.resize(points.size());
    for (std::size_t i = 0; i < points.size(); ++i) moved_[i] = surface.stretch * points[i];
    points = moved_;
  }
  if (source[0] != surface.source[0] || points.size() != surface.points.size())
    build(part, surface, points, triangles);
  surface.points.assign(points.begin(), points.end());
  surface.stamp = nextStamp_++;
  surface.source = source;
}

void TouchScene::build(const Part& part, Surface& surface, std::span<const Vec3f> points,
                       std::span<const Eigen::Vector3i> triangles) {
  surface.isSound = false;
  if (triangles.empty()) return;
  try {
    surface.mesh = std::make_shared<const haptics::TouchMesh>(points, triangles);
    surface.isSound = true;
    ++builds_;
  } catch (const std::invalid_argument& bad) {
    scene_.warn(*part.shape, std::string(bad.what()) + ": can't be touched");
  }
}

void TouchScene::fill(haptics::TouchFrame& frame, double stiffness, double damping) {
  std::size_t count = 0;
  for (std::size_t id = 0; id < parts_.size(); ++id) {
    const Part& part = parts_[id];
    const Surface& surface = surfaces_[id];
    if (part.geometry == nullptr || !surface.isSound) continue;
    if (count == frame.shapes.size()) frame.shapes.emplace_back();
    haptics::TouchFrameShape& shape = frame.shapes[count];
    if (shape.mesh != surface.mesh) shape.mesh = surface.mesh;
    if (shape.stamp != surface.stamp) {
      try {
        shape.points.fit(*surface.mesh, surface.points);
        ++refits_;
      } catch (const std::invalid_argument& bad) {
        scene_.warn(*part.shape, std::string(bad.what()) + ": is felt as it was last");
        if (shape.stamp == 0 || shape.id != id) continue;
      }
      shape.stamp = surface.stamp;
    }
    shape.id = static_cast<std::uint32_t>(id);
    shape.pose = surface.pose;
    shape.surface = part.surface->surfaceOn(stiffness, damping);
    shape.surface.twoSided = surface.isTwoSided;
    ++count;
  }
  frame.shapes.resize(count);
  frame.instants.resize(count);
  frame.effects.clear();
  for (const Effect& effect : effects_) frame.effects.push_back(effect.force);
}

}  // namespace pleura
