#pragma once

#include <vector>

#include <pleura/x3d/browser/render/draw_list.h>
#include <pleura/x3d/browser/render/gl_objects.h>

namespace pleura::render {

/// The kinds of a frame's lights, the headlight last.
using LightKinds = std::vector<Light::Kind>;

/// The lights of a frame in a uniform buffer, as shaders::surfaceFragment reads them.
class LightBuffer {
 public:
  static constexpr GLuint binding = 0;

  explicit LightBuffer(const GlFunctions& gl) : gl_(gl), buffer_(gl) {}

  /// Sends list.lights, in view space, then the headlight.
  LightKinds update(const DrawList& list);

 private:
  const GlFunctions& gl_;
  GlBuffer buffer_;
};

}  // namespace pleura::render
