#pragma once

#include <pleura/nodes/standard/shape/x3d_shape_node.h>
#include <pleura/x3d/browser/render/draw_list.h>

namespace pleura {

/// How a shape's surface looks, and how wide its lines and points are [pixel].
struct Surface {
  render::Material material;
  float size = 1;
};

/// X3D 12.2.2: no Appearance or no Material is unlit white.
Surface surfaceOf(X3DShapeNode& shape);

}  // namespace pleura
