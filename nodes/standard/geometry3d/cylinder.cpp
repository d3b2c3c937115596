#include <array>

#include <pleura/nodes/core/node_type.h>
#include <pleura/nodes/standard/geometry3d/cylinder.h>
#include <pleura/nodes/standard/geometry3d/revolved_surface.h>

namespace pleura {

void Cylinder::declare(NodeType& type) {
  X3DGeometryNode::declare(type);
  type.named("Cylinder", "Geometry3D", 1).containedIn("geometry").means("a cylinder along the y axis");
  using enum Access;
  type.field<&Cylinder::bottom>("bottom", inputOutput, true).means("whether the bottom is drawn");
  type.field<&Cylinder::height>("height", initializeOnly, 2)
      .measuredIn(Unit::length)
      .positive()
      .means("height");
  type.field<&Cylinder::radius>("radius", initializeOnly, 1)
      .measuredIn(Unit::length)
      .positive()
      .means("radius");
  type.field<&Cylinder::side>("side", inputOutput, true).means("whether the side is drawn");
  type.field<&Cylinder::solid>("solid", initializeOnly, true).means("whether only front faces are drawn");
  type.field<&Cylinder::top>("top", inputOutput, true).means("whether the top is drawn");
}

void Cylinder::updateMesh(RenderMesh& mesh) {
  if (!watch_.changed(radius, height, side, top, bottom, solid)) return;
  startPrimitive(mesh, solid.getValue());
  const float r = radius.getValue();
  const float h = height.getValue() / 2;
  if (side.getValue()) addRevolved(std::array<ProfilePoint, 2>{{{r, h, 1, 0}, {r, -h, 1, 0}}}, mesh);
  if (top.getValue()) addRevolved(std::array<ProfilePoint, 2>{{{0, h, 0, 1}, {r, h, 0, 1}}}, mesh);
  if (bottom.getValue()) addRevolved(std::array<ProfilePoint, 2>{{{r, -h, 0, -1}, {0, -h, 0, -1}}}, mesh);
}

}  // namespace pleura
