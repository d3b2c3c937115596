#include <pleura/nodes/core/node_type.h>
#include <pleura/nodes/standard/rendering/x3d_geometry_node.h>

namespace pleura {

void X3DGeometryNode::declare(NodeType& type) {
  Node::declare(type);
  using enum Access;
  type.field<&X3DGeometryNode::isTouched>("isTouched", outputOnly, {})
      .extension()
      .means("whether a haptic device touches it, one entry a device");
  type.field<&X3DGeometryNode::force>("force", outputOnly, {})
      .extension()
      .measuredIn(Unit::force)
      .means("on the hand, one entry a device");
  type.field<&X3DGeometryNode::contactPoint>("contactPoint", outputOnly, {})
      .extension()
      .measuredIn(Unit::length)
      .means("where it is touched last, one entry a device");
  type.field<&X3DGeometryNode::contactNormal>("contactNormal", outputOnly, {})
      .extension()
      .means("out of the surface where it is touched last, one entry a device");
  type.field<&X3DGeometryNode::contactDepth>("contactDepth", outputOnly, {})
      .extension()
      .measuredIn(Unit::length)
      .means("how far it is pressed in, one entry a device; 0: not touched");
}

}  // namespace pleura
