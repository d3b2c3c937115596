#include <algorithm>

#include <pleura/nodes/core/node_type.h>
#include <pleura/nodes/standard/rendering/coordinate_double.h>

namespace pleura {

void CoordinateDouble::declare(NodeType& type) {
  Node::declare(type);
  type.named("CoordinateDouble", "Rendering", 1)
      .containedIn("coord")
      .means("points of a geometry in double precision");
  using enum Access;
  type.field<&CoordinateDouble::point>("point", inputOutput, {}).measuredIn(Unit::length).means("points");
}

std::span<const Vec3f> CoordinateDouble::points() {
  if (watch_.changed(point)) {
    const auto& from = point.getValue();
    points_.resize(from.size());
    std::transform(from.begin(), from.end(), points_.begin(),
                   [](const Vec3d& p) { return Vec3f(p.cast<float>()); });
  }
  return points_;
}

}  // namespace pleura
