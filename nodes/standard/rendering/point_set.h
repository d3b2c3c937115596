#pragma once

#include <pleura/nodes/standard/rendering/coordinate_geometry_node.h>

namespace pleura {

/// Points.
class PointSet : public CoordinateGeometryNode {
 public:
  static void declare(NodeType& type);

 protected:
  bool topologyChanged() override { return false; }
  void collect(std::size_t pointCount, FaceList& faces) override;
  std::vector<std::uint32_t> primitives(const FaceList& faces, std::span<const Vec3f> points) override;
  void setProperties(RenderMesh& mesh) override;
};

}  // namespace pleura
