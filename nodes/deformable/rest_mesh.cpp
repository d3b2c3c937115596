#include <pleura/nodes/deformable/rest_mesh.h>
#include <pleura/nodes/standard/geometry3d/indexed_face_set.h>
#include <pleura/nodes/standard/rendering/coordinate.h>
#include <pleura/nodes/standard/rendering/indexed_triangle_set.h>

namespace pleura {

namespace {

void addFan(TriangleMesh& mesh, std::span<const std::int32_t> face) {
  const auto count = static_cast<std::int32_t>(mesh.points.size());
  for (const auto corner : face)
    if (corner < 0 || corner >= count) return;
  for (std::size_t i = 2; i < face.size(); ++i) mesh.triangles.emplace_back(face[0], face[i - 1], face[i]);
}

}  // namespace

TriangleMesh restMesh(X3DGeometryNode& geometry) {
  TriangleMesh mesh;
  auto* composed = dynamic_cast<X3DComposedGeometryNode*>(&geometry);
  auto* coordinate = composed != nullptr ? dynamic_cast<Coordinate*>(composed->coord.get()) : nullptr;
  if (coordinate == nullptr) return mesh;
  mesh.points = coordinate->point.getValue();
  if (auto* triangles = dynamic_cast<IndexedTriangleSet*>(composed)) {
    const auto& index = triangles->index.getValue();
    for (std::size_t i = 0; i + 2 < index.size(); i += 3) addFan(mesh, std::span(index).subspan(i, 3));
  } else if (auto* faces = dynamic_cast<IndexedFaceSet*>(composed)) {
    const std::span<const std::int32_t> index = faces->coordIndex.getValue();
    std::size_t first = 0;
    for (std::size_t i = 0; i <= index.size(); ++i) {
      if (i < index.size() && index[i] >= 0) continue;
      addFan(mesh, index.subspan(first, i - first));
      first = i + 1;
    }
  }
  return mesh;
}

}  // namespace pleura
