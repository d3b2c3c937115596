#pragma once

#include <vector>

#include <pleura/fields/typed_field.h>
#include <pleura/nodes/core/typed_node_field.h>
#include <pleura/nodes/standard/core/x3d_child_node.h>
#include <pleura/nodes/thorax/deformable_shape2.h>

namespace pleura {

/// Says where the points of an organ are now that is held by what is around it: those near a wall follow it
/// exactly, those between follow smoothly or are left to the organ's deformer. Bindings are made once, from
/// the shapes at rest, when somebody first asks. Its outputs are routed to the organ's contactIndex and
/// contactPoint.
class ContactsNode : public X3DChildNode {
 public:
  SFFloat inflation;
  TypedSFNode<DeformableShape2> organ;
  SFBool fillsBetween;

  class Shape : public TypedField<MFVec3f, AnyNumber<Any<MFVec3f, SFFloat>>> {
    void update() override { static_cast<ContactsNode*>(getOwner())->evaluateShape(value); }
  };
  Shape shape;

  class Index : public TypedField<MFInt32, Types<MFVec3f, SFBool>> {
    void update() override { static_cast<ContactsNode*>(getOwner())->evaluateIndex(value); }
  };
  Index index;

  class Point : public TypedField<MFVec3f, Types<MFVec3f, SFBool>> {
    void update() override { static_cast<ContactsNode*>(getOwner())->evaluatePoint(value); }
  };
  Point point;

  static void declare(NodeType& type);

 protected:
  void onInitialize() override;
  /// Binds to the shapes at rest; once, and again when the organ's rest shape changes. Throws
  /// std::invalid_argument.
  virtual void bind() = 0;
  /// Where the points of the organ are now, into `all`, one a point.
  virtual void follow(std::span<Vec3f> all) = 0;
  /// The points that a wall moves, ascending. Only after bind().
  virtual std::span<const int> driven() const = 0;
  /// What moves the points, beside the inflation.
  virtual std::vector<Field*> movers() = 0;

 private:
  bool isBound();
  void evaluateShape(std::vector<Vec3f>& out);
  void evaluateIndex(std::vector<int>& out);
  void evaluatePoint(std::vector<Vec3f>& out);

  std::uint64_t boundStamp_ = 0;
  bool usable_ = false;
};

}  // namespace pleura
