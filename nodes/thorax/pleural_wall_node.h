#pragma once

#include <vector>

#include <pleura/fields/typed_field.h>
#include <pleura/nodes/core/typed_node_field.h>
#include <pleura/nodes/standard/core/x3d_child_node.h>
#include <pleura/nodes/standard/grouping/transform.h>
#include <pleura/nodes/thorax/motion/pleural_wall.h>

namespace pleura {

/// The inner surface of one half of the cage, rolled over its bones at rest and carried by them: what the
/// lung and the zone of apposition slide on. Built when it is first asked for.
class PleuralWallNode : public X3DChildNode {
 public:
  SFFloat side;
  SFVec3f low;
  SFVec3f high;
  SFFloat cupola;
  MFNode bones;

  class Points : public TypedField<MFVec3f, AnyNumber<SFMatrix4f>> {
    void update() override { static_cast<PleuralWallNode*>(getOwner())->evaluate(value); }
  };
  Points points;

  /// At rest. Throws std::invalid_argument when the bones make no wall.
  const PleuralWall& wall();
  /// The grid where the bones are now as (x, y, z, 1), of the shape of wall().rest.
  std::span<const Vec4f> now() { return points.getValue(), now_; }

  static void declare(NodeType& type);

 protected:
  void onInitialize() override;

 private:
  void evaluate(std::vector<Vec3f>& shown);
  void build();
  int bodyNumber(Transform& body);

  bool isBuilt_ = false;
  PleuralWall wall_;
  std::vector<Transform*> bodies_;
  std::vector<BodyDisplacement> displacements_;
  std::vector<Vec4f> now_;
};

}  // namespace pleura
