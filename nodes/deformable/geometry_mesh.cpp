#include <pleura/nodes/deformable/geometry_mesh.h>
#include <pleura/nodes/standard/geometry3d/indexed_face_set.h>
#include <pleura/nodes/standard/rendering/coordinate.h>
#include <pleura/nodes/standard/rendering/indexed_triangle_set.h>

namespace pleura {

namespace {

void addFan(std::vector<Eigen::Vector3i>& triangles, std::span<const std::int32_t> face, std::size_t points) {
  for (const auto corner : face)
    if (corner < 0 || static_cast<std::size_t>(corner) >= points) return;
  for (std::size_t i = 2; i < face.size(); ++i) triangles.emplace_back(face[0], face[i - 1], face[i]);
}

}  // namespace

std::vector<Eigen::Vector3i> trianglesOf(X3DGeometryNode& geometry, std::size_t points) {
  std::vector<Eigen::Vector3i> triangles;
  if (auto* set = dynamic_cast<IndexedTriangleSet*>(&geometry)) {
    const std::span<const std::int32_t> index = set->index.getValue();
    for (std::size_t i = 0; i + 2 < index.size(); i += 3) addFan(triangles, index.subspan(i, 3), points);
  } else if (auto* faces = dynamic_cast<IndexedFaceSet*>(&geometry)) {
    const std::span<const std::int32_t> index = faces->coordIndex.getValue();
    std::size_t first = 0;
    for (std::size_t i = 0; i <= index.size(); ++i) {
      if (i < index.size() && index[i] >= 0) continue;
      addFan(triangles, index.subspan(first, i - first), points);
      first = i + 1;
    }
  }
  return triangles;
}

TriangleMesh meshOf(X3DGeometryNode& geometry) {
  auto* composed = dynamic_cast<X3DComposedGeometryNode*>(&geometry);
  auto* coordinate = composed != nullptr ? dynamic_cast<Coordinate*>(composed->coord.get()) : nullptr;
  if (coordinate == nullptr) return {};
  const auto& points = coordinate->point.getValue();
  return {points, trianglesOf(geometry, points.size())};
}

}  // namespace pleura
