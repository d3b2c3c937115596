#include <pleura/nodes/core/node_type.h>
#include <pleura/nodes/standard/grouping/x3d_bounded_object.h>

namespace pleura {

void X3DBoundedObject::declare(NodeType& type) {
  using enum Access;
  type.field<&X3DBoundedObject::bboxCenter>("bboxCenter", initializeOnly, Vec3f::Zero())
      .measuredIn(Unit::length)
      .means("centre of the box that bounds the contents");
  type.field<&X3DBoundedObject::bboxDisplay>("bboxDisplay", inputOutput, false)
      .means("whether the bounding box is drawn");
  type.field<&X3DBoundedObject::bboxSize>("bboxSize", initializeOnly, Vec3f(-1, -1, -1))
      .measuredIn(Unit::length)
      .means("size of the box that bounds the contents; -1 -1 -1: not known");
  type.field<&X3DBoundedObject::visible>("visible", inputOutput, true)
      .means("whether the contents are drawn");
}

}  // namespace pleura
