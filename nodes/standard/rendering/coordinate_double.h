#pragma once

#include <pleura/nodes/standard/core/field_watch.h>
#include <pleura/nodes/standard/rendering/x3d_coordinate_node.h>

namespace pleura {

/// Points of a geometry in double precision.
class CoordinateDouble : public X3DCoordinateNode {
 public:
  MFVec3d point;

  static void declare(NodeType& type);

  std::span<const Vec3f> points() override;
  Field& source() override { return point; }

 private:
  FieldWatch watch_;
  std::vector<Vec3f> points_;
};

}  // namespace pleura
