#pragma once

#include <pleura/nodes/standard/rendering/x3d_normal_node.h>

namespace pleura {

/// Normals of a geometry.
class Normal : public X3DNormalNode {
 public:
  MFVec3f vector;

  static void declare(NodeType& type);

  std::span<const Vec3f> normals() override { return vector.getValue(); }
  Field& source() override { return vector; }
};

}  // namespace pleura
