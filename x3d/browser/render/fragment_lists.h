#pragma once

#include <pleura/x3d/browser/render/transparency_pass.h>

namespace pleura::render {

/// Transparency with OpenGL 4.3 (Yang et al. 2010): one pass over the surfaces puts every fragment into its
/// pixel's list, with colour, depth and the samples it covers; then each pixel blends its list in order. The
/// surfaces are gone through once and not twice a layer as in DepthPeeling, which under software OpenGL costs
/// ten times as much.
class FragmentLists : public TransparencyPass {
 public:
  FragmentLists(const GlFunctions& gl, int samples);

  int draw(const RenderTarget& target, std::span<const SurfaceDraw> surfaces, const Frame& frame) override;

 private:
  void reserve(std::uint32_t capacity);
  std::uint32_t collect(const RenderTarget& target, std::span<const SurfaceDraw> surfaces,
                        const Frame& frame);
  void blend(const RenderTarget& target) const;

  const GlFunctions& gl_;
  SurfacePass lister_;
  ShaderProgram blender_;
  GlVertexArray noVertices_;
  GlBuffer heads_, fragments_;
  std::uint32_t capacity_ = 0;  // of fragments_
  int pixels_ = 0;              // of heads_
};

}  // namespace pleura::render
