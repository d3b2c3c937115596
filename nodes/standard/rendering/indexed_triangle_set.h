#pragma once

#include <pleura/nodes/standard/rendering/x3d_composed_geometry_node.h>

namespace pleura {

/// Triangles that share points.
class IndexedTriangleSet : public X3DComposedGeometryNode {
 public:
  MFInt32 index;
  MFInt32 set_index;

  static void declare(NodeType& type);

 protected:
  void onInitialize() override;
  bool topologyChanged() override;
  void collect(std::size_t pointCount, FaceList& faces) override;

 private:
  FieldWatch topology_;
};

}  // namespace pleura
