#include <cmath>
#include <numbers>

#include <pleura/nodes/core/node_type.h>
#include <pleura/nodes/standard/geometry3d/revolved_surface.h>
#include <pleura/nodes/standard/geometry3d/sphere.h>

namespace pleura {

void Sphere::declare(NodeType& type) {
  X3DGeometryNode::declare(type);
  type.named("Sphere", "Geometry3D", 1).containedIn("geometry").means("a sphere around the origin");
  using enum Access;
  type.field<&Sphere::radius>("radius", initializeOnly, 1)
      .measuredIn(Unit::length)
      .positive()
      .means("radius");
  type.field<&Sphere::solid>("solid", initializeOnly, true).means("whether only front faces are drawn");
}

void Sphere::updateMesh(RenderMesh& mesh) {
  if (!watch_.changed(radius, solid)) return;
  startPrimitive(mesh, solid.getValue());
  constexpr int kRings = 16;
  const float r = radius.getValue();
  std::vector<ProfilePoint> profile;
  for (int i = 0; i <= kRings; ++i) {
    const double angle = std::numbers::pi * i / kRings;
    const bool isPole = i == 0 || i == kRings;
    const float s = isPole ? 0 : static_cast<float>(std::sin(angle));
    const auto c = static_cast<float>(std::cos(angle));
    profile.push_back({r * s, r * c, s, c});
  }
  addRevolved(profile, mesh);
}

}  // namespace pleura
