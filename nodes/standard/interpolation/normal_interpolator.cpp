#include <pleura/nodes/standard/interpolation/normal_interpolator.h>

namespace pleura {

void NormalInterpolator::declare(NodeType& type) {
  KeyFrameInterpolator::declare(type);
  type.named("NormalInterpolator", "Interpolation", 2)
      .means("lists of normals between keys, on the unit sphere");
}

}  // namespace pleura
