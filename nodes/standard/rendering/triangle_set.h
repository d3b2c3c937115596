#pragma once

#include <pleura/nodes/standard/rendering/x3d_composed_geometry_node.h>

namespace pleura {

/// Triangles, three points each.
class TriangleSet : public X3DComposedGeometryNode {
 public:
  static void declare(NodeType& type);

 protected:
  bool topologyChanged() override;
  void collect(std::size_t pointCount, FaceList& faces) override;
  double smoothAngle() override { return 0; }

 private:
  FieldWatch topology_;
};

}  // namespace pleura
