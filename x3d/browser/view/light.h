#pragma once

#include <optional>

#include <pleura/nodes/standard/lighting/x3d_light_node.h>
#include <pleura/x3d/browser/render/draw_list.h>

namespace pleura {

/// A light as the renderer takes it.
struct PlacedLight {
  render::Light light;
  bool isGlobal = true;  // shines on everything, not only on its siblings and what is below them
};

/// `toWorld` is of the group that the light stands in. Nothing for a light that is off.
std::optional<PlacedLight> placedLight(X3DLightNode& node, const Matrix4f& toWorld);

}  // namespace pleura
