#pragma once

#include <span>

#include <pleura/x3d/browser/render/render_target.h>
#include <pleura/x3d/browser/render/surface_pass.h>

namespace pleura::render {

/// Blends transparent surfaces over the opaque ones, from the farthest to the nearest at every sample.
/// Sorting objects or triangles is not enough: lungs are concave and two-sided, pleurae and diaphragm lie
/// millimetres apart, and weighted blending gives the wrong colour.
class TransparencyPass {
 public:
  virtual ~TransparencyPass() = default;

  /// Takes `target` with the opaque surfaces drawn and leaves it resolved. Gives the number of draw calls.
  virtual int draw(const RenderTarget& target, std::span<const SurfaceDraw> surfaces, const Frame& frame) = 0;
};

}  // namespace pleura::render
