#include <pleura/x3d/browser/render/depth_peeling.h>
#include <pleura/x3d/browser/render/shaders.h>

namespace pleura {

DepthPeeling::DepthPeeling(const GlFunctions& gl, const std::string& header)
    : gl_(gl), peel_(gl, header, shaders::peelFragment, SurfacePass::Variants::OnlyOne), anything_(gl) {}

int DepthPeeling::draw(const RenderTarget& target, std::span<const SurfaceDraw> surfaces, const Frame& frame,
                       SurfacePass& shaded) {
  if (surfaces.empty()) return 0;
  int layers = 0, from = 0, to = 1;
  while (layers < maxLayers && findLayer(target, from, to, surfaces, frame)) {
    blendLayer(surfaces, frame, shaded);
    ++layers;
    from = to;
    to = 3 - to;
  }
  return layers;
}

bool DepthPeeling::findLayer(const RenderTarget& target, int from, int to,
                             std::span<const SurfaceDraw> surfaces, const Frame& frame) {
  target.bind(to);
  gl_.ActiveTexture(GL_TEXTURE0);
  gl_.BindTexture(GL_TEXTURE_2D_MULTISAMPLE, target.depth(from));
  gl_.ColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
  gl_.DepthMask(GL_TRUE);
  gl_.DepthFunc(GL_GREATER);
  gl_.ClearDepth(0);
  gl_.Clear(GL_DEPTH_BUFFER_BIT);
  gl_.BeginQuery(GL_SAMPLES_PASSED, anything_);
  for (const SurfaceDraw& surface : surfaces) peel_.draw(surface, frame);
  gl_.EndQuery(GL_SAMPLES_PASSED);
  gl_.ColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  GLuint samples = 0;
  gl_.GetQueryObjectuiv(anything_, GL_QUERY_RESULT, &samples);
  return samples > 0;
}

void DepthPeeling::blendLayer(std::span<const SurfaceDraw> surfaces, const Frame& frame,
                              SurfacePass& shaded) const {
  gl_.DepthMask(GL_FALSE);
  gl_.DepthFunc(GL_EQUAL);
  gl_.Enable(GL_BLEND);
  gl_.BlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
  for (const SurfaceDraw& surface : surfaces) shaded.draw(surface, frame);
  gl_.Disable(GL_BLEND);
}

}  // namespace pleura
