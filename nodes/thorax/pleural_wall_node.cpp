#include <algorithm>
#include <list>
#include <stdexcept>

#include <pleura/nodes/deformable/geometry_mesh.h>
#include <pleura/nodes/standard/grouping/x3d_grouping_node.h>
#include <pleura/nodes/standard/networking/inline.h>
#include <pleura/nodes/thorax/deformable_shape2.h>
#include <pleura/nodes/thorax/pleural_wall_node.h>
#include <pleura/nodes/thorax/skin_deformer.h>

namespace pleura {

namespace {

/// Every shape's triangles below a node, in its own frame; transforms in between are no part of a bone.
void collect(Node& node, std::list<TriangleMesh>& meshes) {
  if (auto* shape = dynamic_cast<X3DShapeNode*>(&node)) {
    if (auto* geometry = shape->geometry.get()) meshes.push_back(meshOf(*geometry));
  } else if (auto* file = dynamic_cast<Inline*>(&node)) {
    for (const auto& child : file->contents.getValue()) collect(*child, meshes);
  } else if (auto* group = dynamic_cast<X3DGroupingNode*>(&node)) {
    for (const auto& child : group->children.getValue()) collect(*child, meshes);
  }
}

SkinDeformer* skinOf(Node& node) {
  auto* organ = dynamic_cast<DeformableShape2*>(&node);
  return organ != nullptr ? dynamic_cast<SkinDeformer*>(organ->deformer.get()) : nullptr;
}

}  // namespace

void PleuralWallNode::declare(NodeType& type) {
  Node::declare(type);
  type.named("PleuralWall", "Pleura")
      .means("inner surface of one half of the cage, which lung and diaphragm slide on");
  using enum Access;
  type.field<&PleuralWallNode::side>("side", initializeOnly, 1).within(-1, 1).means("1 left, -1 right");
  type.field<&PleuralWallNode::low>("low", initializeOnly, Vec3f::Zero())
      .measuredIn(Unit::length)
      .means("lower end of the hemithorax' axis");
  type.field<&PleuralWallNode::high>("high", initializeOnly, Vec3f(0, 0.2f, 0))
      .measuredIn(Unit::length)
      .means("upper end of the hemithorax' axis");
  type.field<&PleuralWallNode::cupola>("cupola", initializeOnly, 0.2f)
      .measuredIn(Unit::length)
      .means("height above the middle of the axis, along it, where the wall closes over the lung");
  type.field<&PleuralWallNode::bones>("bones", initializeOnly, {})
      .means(
          "what bounds the cavity: Transforms of bones, DeformableShape2 with SkinDeformer, shapes that "
          "stay");
  type.field<&PleuralWallNode::points>("points", outputOnly, {})
      .measuredIn(Unit::length)
      .means("the wall's grid now");
}

int PleuralWallNode::bodyNumber(Transform& body) {
  const auto known = std::find(bodies_.begin(), bodies_.end(), &body);
  if (known == bodies_.end()) bodies_.push_back(&body);
  return static_cast<int>(known - bodies_.begin());
}

void PleuralWallNode::onInitialize() {
  for (const auto& bone : bones.getValue()) {
    if (auto* skin = skinOf(*bone)) {
      for (const auto& body : skin->bodies.getValue())
        if (auto* transform = dynamic_cast<Transform*>(body.get())) bodyNumber(*transform);
    } else if (auto* transform = dynamic_cast<Transform*>(bone.get())) {
      bodyNumber(*transform);
    }
  }
  for (auto* body : bodies_) body->matrix.route(points, id);
}

void PleuralWallNode::build() {
  std::list<TriangleMesh> meshes;
  std::vector<WallBody> walls;
  const auto add = [&](Node& bone, const BodyWeights& carriedBy) {
    const auto before = meshes.size();
    collect(bone, meshes);
    for (auto mesh = std::next(meshes.begin(), static_cast<std::ptrdiff_t>(before)); mesh != meshes.end();
         ++mesh)
      walls.push_back({&*mesh, std::vector<BodyWeights>(mesh->points.size(), carriedBy)});
  };
  for (const auto& bone : bones.getValue()) {
    if (auto* skin = skinOf(*bone)) {
      meshes.push_back(static_cast<DeformableShape2&>(*bone).rest());
      auto weights = skin->weights(meshes.back().points.size());
      for (auto& each : weights)
        for (auto& body : std::span(each.body).first(each.count))
          body = static_cast<std::uint8_t>(
              bodyNumber(static_cast<Transform&>(*skin->bodies.getValueByIndex(body))));
      walls.push_back({&meshes.back(), std::move(weights)});
    } else if (auto* transform = dynamic_cast<Transform*>(bone.get())) {
      add(*bone, rigidWith(bodyNumber(*transform)));
    } else {
      add(*bone, {});
    }
  }
  const auto axis =
      hemithoraxAxis(low.getValue().cast<double>(), high.getValue().cast<double>(), side.getValue());
  wall_ = buildPleuralWall(axis, walls, cupola.getValue());
  displacements_.resize(bodies_.size());
  now_ = wall_.rest;
}

const PleuralWall& PleuralWallNode::wall() {
  if (!isBuilt_) build();
  isBuilt_ = true;
  return wall_;
}

void PleuralWallNode::evaluate(std::vector<Vec3f>& shown) {
  wall();
  for (std::size_t k = 0; k < bodies_.size(); ++k) displacements_[k] = displacementOf(*bodies_[k]);
  moveWall(wall_, displacements_, now_);
  shown.resize(now_.size());
  for (std::size_t i = 0; i < now_.size(); ++i) shown[i] = now_[i].head<3>();
}

}  // namespace pleura
