#include <array>

#include <pleura/nodes/core/node_type.h>
#include <pleura/nodes/standard/geometry3d/cone.h>
#include <pleura/nodes/standard/geometry3d/revolved_surface.h>

namespace pleura {

void Cone::declare(NodeType& type) {
  X3DGeometryNode::declare(type);
  type.named("Cone", "Geometry3D", 1)
      .containedIn("geometry")
      .means("a cone along the y axis, its tip on top");
  using enum Access;
  type.field<&Cone::bottom>("bottom", inputOutput, true).means("whether the bottom is drawn");
  type.field<&Cone::bottomRadius>("bottomRadius", initializeOnly, 1)
      .measuredIn(Unit::length)
      .positive()
      .means("radius of the bottom");
  type.field<&Cone::height>("height", initializeOnly, 2).measuredIn(Unit::length).positive().means("height");
  type.field<&Cone::side>("side", inputOutput, true).means("whether the side is drawn");
  type.field<&Cone::solid>("solid", initializeOnly, true).means("whether only front faces are drawn");
}

void Cone::updateMesh(RenderMesh& mesh) {
  if (!watch_.changed(bottomRadius, height, side, bottom, solid)) return;
  startPrimitive(mesh, solid.getValue());
  const float r = bottomRadius.getValue();
  const float h = height.getValue() / 2;
  const Vec2f normal = Vec2f(2 * h, r).normalized();
  if (side.getValue())
    addRevolved(
        std::array<ProfilePoint, 2>{{{0, h, normal.x(), normal.y()}, {r, -h, normal.x(), normal.y()}}}, mesh);
  if (bottom.getValue()) addRevolved(std::array<ProfilePoint, 2>{{{r, -h, 0, -1}, {0, -h, 0, -1}}}, mesh);
}

}  // namespace pleura
