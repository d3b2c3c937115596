#include <stdexcept>

#include <pleura/nodes/thorax/skin_deformer.h>

namespace pleura {

BodyDisplacement displacementOf(Transform& body) { return body.matrix.getValue() - Matrix4f::Identity(); }

void SkinDeformer::declare(NodeType& type) {
  DeformerNode::declare(type);
  type.named("SkinDeformer", "Pleura").means("carries each point by a blend of rigid bodies");
  using enum Access;
  type.field<&SkinDeformer::bodies>("bodies", initializeOnly, {}).means("the Transforms that carry");
  type.field<&SkinDeformer::bodyIndex>("bodyIndex", initializeOnly, {})
      .means("for each point the bodies that carry it, each list ended by -1; an empty one: it stays");
  type.field<&SkinDeformer::weight>("weight", initializeOnly, {})
      .within(0, 1)
      .means("the share of each body, in the order of bodyIndex");
}

std::vector<Field*> SkinDeformer::inputs() {
  std::vector<Field*> matrices;
  for (const auto& body : bodies.getValue())
    if (auto* transform = dynamic_cast<Transform*>(body.get())) matrices.push_back(&transform->matrix);
  return matrices;
}

std::vector<BodyWeights> SkinDeformer::weights(std::size_t points) {
  const auto& share = weight.getValue();
  std::vector<BodyWeights> all;
  std::size_t next = 0;
  BodyWeights one;
  for (const int body : bodyIndex.getValue()) {
    if (body < 0) {
      all.push_back(one);
      one = {};
      continue;
    }
    if (static_cast<std::size_t>(body) >= bodies.size() || next == share.size())
      throw std::invalid_argument(
          "SkinDeformer: bodyIndex names a body that is not there, or a weight is missing");
    one.add(body, share[next++]);
  }
  if (all.size() != points)
    throw std::invalid_argument("SkinDeformer: bodyIndex has " + std::to_string(all.size()) + " lists for " +
                                std::to_string(points) + " points");
  return all;
}

void SkinDeformer::setRest(const TriangleMesh& rest, std::span<const int>) {
  weights_ = weights(rest.points.size());
  rest_ = rest.points;
  displacements_.resize(bodies.size());
}

void SkinDeformer::prepare(std::span<const int>) {
  for (std::size_t k = 0; k < displacements_.size(); ++k)
    displacements_[k] = displacementOf(static_cast<Transform&>(*bodies.getValueByIndex(k)));
}

void SkinDeformer::solve(std::span<const int>, std::span<const Vec3f>, std::span<Vec3f> positions) {
  carryAll(rest_, weights_, displacements_, positions);
}

}  // namespace pleura
