#pragma once

#include <span>

#include <pleura/fields/values.h>
#include <pleura/nodes/standard/rendering/face_list.h>
#include <pleura/nodes/standard/rendering/render_mesh.h>

namespace pleura {

/// Where each vertex of a RenderMesh takes its data from. Made when the topology changes; after that only
/// fill() is called, which allocates nothing.
class VertexLayout {
 public:
  /// Where the data is. `normals` empty: computed, one a smoothing group. `colors` empty: none.
  struct Sources {
    std::span<const Vec3f> points;
    std::span<const Vec3f> normals;
    std::span<const RGBA> colors;
  };

  /// Makes one vertex of all corners that agree in all, and the indices of `mesh` for the runs of corners
  /// in `primitives` (three a triangle, two a line, one a point).
  void assign(std::span<const Corner> corners, std::span<const std::uint32_t> primitives, RenderMesh& mesh);

  /// Writes positions, normals (of triangles) and colours of every vertex. Computed normals are the sum of
  /// the triangles' area vectors, pointing to the side from which they are counterclockwise, or to the other
  /// unless `mesh.ccw`.
  void fill(const Sources& sources, RenderMesh& mesh);

 private:
  void fillComputedNormals(RenderMesh& mesh);

  std::vector<Corner> vertices_;
  std::vector<Vec3d> groups_;  // sums of area vectors
};

}  // namespace pleura
