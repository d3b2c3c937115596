#pragma once

#include <pleura/fields/typed_field.h>
#include <pleura/nodes/core/node_type.h>
#include <pleura/nodes/standard/core/x3d_child_node.h>

namespace pleura {

/// Finds which points of object 2 follow which of object 1, from their distances at rest: once, and again
/// only when an input changes.
class ContactPoints : public X3DChildNode {
 public:
  MFVec3f coord1;
  MFVec3f coord2;
  MFFloat dist;

  /// Pairs, one after the other: the point of object 1 that is followed, the point of object 2 that follows.
  class Pairs : public TypedField<MFInt32, Types<MFVec3f, MFVec3f, MFFloat>> {
   public:
    /// Which of the two distances of `dist` counts.
    explicit Pairs(std::size_t distance = 0) : distance_(distance) {}

   private:
    void update() override;
    std::size_t distance_;
  };
  Pairs touch{0};
  Pairs rigid_touch{1};

  ContactPoints();
  static void declare(NodeType& type);
};

}  // namespace pleura
