#include <pleura/nodes/core/node_type.h>
#include <pleura/nodes/standard/geometry3d/box.h>
#include <pleura/nodes/standard/geometry3d/revolved_surface.h>

namespace pleura {

void Box::declare(NodeType& type) {
  X3DGeometryNode::declare(type);
  type.named("Box", "Geometry3D", 1).containedIn("geometry").means("a box around the origin");
  using enum Access;
  type.field<&Box::size>("size", initializeOnly, Vec3f(2, 2, 2))
      .measuredIn(Unit::length)
      .means("lengths of its edges");
  type.field<&Box::solid>("solid", initializeOnly, true).means("whether only front faces are drawn");
}

void Box::updateMesh(RenderMesh& mesh) {
  if (!watch_.changed(size, solid)) return;
  startPrimitive(mesh, solid.getValue());
  constexpr int kCorners[4][2] = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};
  const Vec3f half = size.getValue() / 2;
  for (int axis = 0; axis < 3; ++axis)
    for (const int side : {-1, 1}) {
      const auto first = static_cast<std::uint32_t>(mesh.positions.size());
      for (const auto& corner : kCorners) {
        Vec3f p;
        p[axis] = static_cast<float>(side);
        p[(axis + 1) % 3] = static_cast<float>(side * corner[0]);
        p[(axis + 2) % 3] = static_cast<float>(corner[1]);
        mesh.positions.push_back(p.cwiseProduct(half));
        mesh.normals.push_back(Vec3f::Unit(axis) * static_cast<float>(side));
      }
      for (const std::uint32_t corner : {0u, 1u, 2u, 0u, 2u, 3u}) mesh.indices.push_back(first + corner);
    }
}

}  // namespace pleura
