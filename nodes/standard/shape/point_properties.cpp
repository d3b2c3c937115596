#include <pleura/nodes/core/node_type.h>
#include <pleura/nodes/standard/shape/point_properties.h>

namespace pleura {

void PointProperties::declare(NodeType& type) {
  Node::declare(type);
  type.named("PointProperties", "Shape", 5).containedIn("pointProperties").means("how points are drawn");
  using enum Access;
  type.field<&PointProperties::attenuation>("attenuation", inputOutput, Vec3f(1, 0, 0))
      .means("factors of 1, distance and its square in the loss");
  type.field<&PointProperties::pointSizeMaxValue>("pointSizeMaxValue", inputOutput, 1)
      .atLeast(0)
      .means("largest size of a point");
  type.field<&PointProperties::pointSizeMinValue>("pointSizeMinValue", inputOutput, 1)
      .atLeast(0)
      .means("smallest size of a point");
  type.field<&PointProperties::pointSizeScaleFactor>("pointSizeScaleFactor", inputOutput, 1)
      .atLeast(1)
      .means("times the smallest point that can be drawn");
}

}  // namespace pleura
