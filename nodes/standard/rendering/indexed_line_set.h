#pragma once

#include <pleura/nodes/standard/rendering/coordinate_geometry_node.h>

namespace pleura {

/// Polylines that share points.
class IndexedLineSet : public CoordinateGeometryNode {
 public:
  MFInt32 colorIndex;
  SFBool colorPerVertex;
  MFInt32 coordIndex;
  MFInt32 set_colorIndex;
  MFInt32 set_coordIndex;

  static void declare(NodeType& type);

 protected:
  void onInitialize() override;
  bool topologyChanged() override;
  void collect(std::size_t pointCount, FaceList& faces) override;
  std::vector<std::uint32_t> primitives(const FaceList& faces, std::span<const Vec3f> points) override;
  void setProperties(RenderMesh& mesh) override;

 private:
  FieldWatch topology_;
};

}  // namespace pleura
