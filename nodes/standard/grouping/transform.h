#pragma once

#include <pleura/fields/typed_field.h>
#include <pleura/nodes/standard/grouping/x3d_grouping_node.h>

namespace pleura {

/// Children in a coordinate system of their own.
class Transform : public X3DGroupingNode {
 public:
  SFVec3f center;
  SFRotation rotation;
  SFVec3f scale;
  SFRotation scaleOrientation;
  SFVec3f translation;

  /// From the children's coordinates to the parent's. Evaluated when it is read; no field of X3D's.
  class Matrix : public TypedField<SFMatrix4f, Types<SFVec3f, SFRotation, SFVec3f, SFRotation, SFVec3f>> {
   protected:
    void update() override;
  };
  Matrix matrix;

  Transform();
  static void declare(NodeType& type);
};

}  // namespace pleura
