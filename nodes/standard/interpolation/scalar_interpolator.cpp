#include <pleura/nodes/standard/interpolation/scalar_interpolator.h>

namespace pleura {

void ScalarInterpolator::declare(NodeType& type) {
  KeyFrameInterpolator::declare(type);
  type.named("ScalarInterpolator", "Interpolation", 1).means("numbers along a polyline of keys");
}

}  // namespace pleura
