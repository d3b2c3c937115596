#pragma once

#include <pleura/nodes/core/typed_node_field.h>
#include <pleura/nodes/standard/core/field_watch.h>
#include <pleura/nodes/standard/rendering/vertex_layout.h>
#include <pleura/nodes/standard/rendering/x3d_color_node.h>
#include <pleura/nodes/standard/rendering/x3d_coordinate_node.h>
#include <pleura/nodes/standard/rendering/x3d_geometry_node.h>
#include <pleura/nodes/standard/rendering/x3d_normal_node.h>

namespace pleura {

class NodeType;

/// What all geometries made of a Coordinate have in common: points, lines and faces. A subclass says which
/// corners its faces, lines or points have; the topology is built when that changes, or how many points,
/// normals or colours there are. Otherwise only the vertices are written anew.
class CoordinateGeometryNode : public X3DGeometryNode {
 public:
  MFNode attrib;
  TypedSFNode<X3DColorNode> color;
  TypedSFNode<X3DCoordinateNode> coord;
  SFNode fogCoord;
  TypedSFNode<X3DNormalNode> normal;

  static void declare(NodeType& type);

 protected:
  void updateMesh(RenderMesh& mesh) override;

  /// Whether what collect() reads has changed since the last call.
  virtual bool topologyChanged() = 0;
  /// The corners of the faces, lines or points. The numbers may be wrong: they are checked afterwards.
  virtual void collect(std::size_t pointCount, FaceList& faces) = 0;
  /// Which corners make triangles, lines or points.
  virtual std::vector<std::uint32_t> primitives(const FaceList& faces, std::span<const Vec3f> points) = 0;
  /// Sets primitive, solid and ccw.
  virtual void setProperties(RenderMesh& mesh) = 0;
  /// Faces that meet at less are shaded as one where no normals are given [rad].
  virtual double smoothAngle() { return 0; }

 private:
  void readSources();
  bool sourcesChanged();
  void rebuild(RenderMesh& mesh);
  void settleNormals(FaceList& faces, const RenderMesh& mesh);
  void settleColors(FaceList& faces);
  void warnOnce(const std::string& message);

  VertexLayout layout_;
  VertexLayout::Sources sources_;
  FieldWatch nodes_;
  FieldWatch values_[3];
  std::size_t counts_[3] = {};
  bool usesNormals_ = false;
  bool usesColors_ = false;
  bool hasWarned_ = false;
};

/// The number of the normal or colour of a corner: in `index` where there is one, else the point's or the
/// face's own; -1 when the index ends before.
std::int32_t attributeNumber(const std::vector<std::int32_t>& index, bool perVertex, std::size_t position,
                             std::size_t face, std::int32_t point);

}  // namespace pleura
