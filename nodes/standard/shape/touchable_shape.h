#pragma once

#include <pleura/fields/field_types.h>
#include <pleura/nodes/deformable/mesh/triangle_mesh.h>

namespace pleura {

/// A shape that is shown as touch has pressed it, and felt as it is without: what the hand presses in does
/// not run away from it.
class TouchableShape {
 public:
  /// The points of the shape without any touch [m], and the triangles among them.
  virtual MFVec3f& untouchedPoints() = 0;
  virtual std::span<const Eigen::Vector3i> untouchedTriangles() = 0;

 protected:
  ~TouchableShape() = default;
};

}  // namespace pleura
