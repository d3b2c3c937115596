#include <algorithm>
#include <utility>

#include <pleura/nodes/deformable/geometry_mesh.h>
#include <pleura/nodes/standard/shape/x3d_shape_node.h>
#include <pleura/x3d/browser/tradeoff/organ_breath.h>

namespace pleura {

namespace {

/// The field of that name and class; null where there is none.
template <class FieldClass>
FieldClass* fieldOf(Node& node, std::string_view name) {
  return dynamic_cast<FieldClass*>(node.getField(name));
}

struct Held {
  Node* contacts;
  Node* shape;
  OrganBreath breath;
};

std::vector<Held> heldOrgans(Scene& scene) {
  std::vector<Held> held;
  for (const auto& [name, node] : scene.document().names) {
    auto* fills = fieldOf<SFBool>(*node, "fillsBetween");
    auto* organ = fieldOf<SFNode>(*node, "organ");
    auto* shape = organ != nullptr ? dynamic_cast<X3DShapeNode*>(organ->getValue().get()) : nullptr;
    if (fills == nullptr || shape == nullptr || shape->geometry.get() == nullptr) continue;
    fills->setValue(false);
    OrganBreath breath{.organ = shape->describe(), .rest = {}, .rigid = {}, .driven = {}, .moments = {}};
    breath.rest.points = fieldOf<MFVec3f>(*shape, "origCoord")->getValue();
    breath.rest.triangles = trianglesOf(*shape->geometry.get(), breath.rest.points.size());
    breath.rigid = fieldOf<MFInt32>(*shape, "rigid_points")->getValue();
    const bool isKnown = std::any_of(held.begin(), held.end(),
                                     [&](const Held& each) { return each.breath.organ == breath.organ; });
    if (!isKnown) held.push_back({node.get(), shape, std::move(breath)});
  }
  return held;
}

/// The pressure that the scene's own deformer is given.
float pressureOn(const Held& held) {
  auto* chosen = fieldOf<SFNode>(*held.shape, "deformer");
  const NodePtr deformer = chosen != nullptr ? chosen->getValue() : nullptr;
  auto* pressure = deformer ? fieldOf<SFFloat>(*deformer, "pressure") : nullptr;
  auto* atRest = deformer ? fieldOf<SFFloat>(*deformer, "restPressure") : nullptr;
  return pressure != nullptr && atRest != nullptr ? pressure->getValue() - atRest->getValue() : 0;
}

}  // namespace

std::vector<OrganBreath> recordBreath(Scene& scene, double seconds, int moments) {
  std::vector<Held> held = heldOrgans(scene);
  scene.tick(0);
  for (int k = 1; k <= moments; ++k) {
    const Time time = seconds * k / (moments + 1);
    scene.tick(time);
    for (Held& each : held) {
      each.breath.driven = fieldOf<MFInt32>(*each.contacts, "index")->getValue();
      each.breath.moments.push_back({.time = time,
                                     .targets = fieldOf<MFVec3f>(*each.contacts, "point")->getValue(),
                                     .filled = fieldOf<MFVec3f>(*each.contacts, "shape")->getValue(),
                                     .shown = fieldOf<MFVec3f>(*each.shape, "deformedCoord")->getValue(),
                                     .pressure = pressureOn(each)});
    }
  }
  std::vector<OrganBreath> breaths;
  for (Held& each : held) breaths.push_back(std::move(each.breath));
  return breaths;
}

}  // namespace pleura
