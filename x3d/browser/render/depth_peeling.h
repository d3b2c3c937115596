#pragma once

#include <pleura/x3d/browser/render/transparency_pass.h>

namespace pleura::render {

/// Transparency with OpenGL 3.3 (Everitt 2001, from the back): per layer, the farthest depth in front of the
/// layer before is found, then what stands at that depth is shaded and blended over the picture. Two passes
/// over the surfaces a layer.
class DepthPeeling : public TransparencyPass {
 public:
  /// Beyond this many surfaces behind one another the nearest are left out.
  static constexpr int maxLayers = 64;

  /// `perSample`: the OpenGL has GL_ARB_sample_shading; without it the target must have one sample.
  DepthPeeling(const GlFunctions& gl, bool perSample);

  int draw(const RenderTarget& target, std::span<const SurfaceDraw> surfaces, const Frame& frame) override;

 private:
  bool findLayer(const RenderTarget& target, int from, int to, std::span<const SurfaceDraw> surfaces,
                 const Frame& frame);
  void blendLayer(std::span<const SurfaceDraw> surfaces, const Frame& frame);

  const GlFunctions& gl_;
  SurfacePass peel_, shaded_;
  GlQuery anything_;
};

}  // namespace pleura::render
