#pragma once

#include <vector>

#include <pleura/nodes/core/typed_node_field.h>
#include <pleura/nodes/deformable/deformer_node.h>
#include <pleura/nodes/standard/grouping/transform.h>
#include <pleura/nodes/thorax/motion/skin.h>

namespace pleura {

/// Carries each point by a blend of rigid bodies: p' = p + sum w_k (M_k p - p). A costal cartilage, which
/// bends between its rib and the sternum.
class SkinDeformer : public DeformerNode {
 public:
  TypedMFNode<Transform> bodies;
  MFInt32 bodyIndex;
  MFFloat weight;

  void setRest(const TriangleMesh& rest, std::span<const int> rigidPoints) override;
  void prepare(std::span<const int> driven) override;
  void solve(std::span<const int> driven, std::span<const Vec3f> targets,
             std::span<Vec3f> positions) override;
  std::vector<Field*> inputs() override;

  /// One a point. Throws std::invalid_argument unless bodyIndex has one list for each of `points` points,
  /// each ended by -1, its bodies exist, and there is a weight for each.
  std::vector<BodyWeights> weights(std::size_t points);

  static void declare(NodeType& type);

 private:
  std::vector<Vec3f> rest_;
  std::vector<BodyWeights> weights_;
  std::vector<BodyDisplacement> displacements_;
};

/// What a body's motion from its rest adds to a point, in its parent's frame.
BodyDisplacement displacementOf(Transform& body);

}  // namespace pleura
