#pragma once

#include <pleura/nodes/standard/rendering/x3d_coordinate_node.h>

namespace pleura {

/// Points of a geometry.
class Coordinate : public X3DCoordinateNode {
 public:
  MFVec3f point;

  static void declare(NodeType& type);

  std::span<const Vec3f> points() override { return point.getValue(); }
  Field& source() override { return point; }
};

}  // namespace pleura
