#include <pleura/x3d/browser/render/depth_peeling.h>
#include <pleura/x3d/browser/render/shaders.h>

namespace pleura::render {
namespace {

constexpr const char* kPeelingVersion = "#version 330 core\n";

std::string peelHeader(bool perSample) {
  if (!perSample) return std::string(kPeelingVersion) + "#define SAMPLE 0\n";
  return std::string(kPeelingVersion) +
         "#extension GL_ARB_sample_shading : require\n#define SAMPLE gl_SampleID\n";
}

}  // namespace

DepthPeeling::DepthPeeling(const GlFunctions& gl, bool perSample)
    : gl_(gl),
      peel_(gl, peelHeader(perSample), shaders::peelFragment, SurfacePass::Variants::OnlyOne),
      shaded_(gl, kPeelingVersion, std::string(shaders::surfaceFragment) + shaders::surfaceOutput),
      anything_(gl) {}

int DepthPeeling::draw(const RenderTarget& target, std::span<const SurfaceDraw> surfaces,
                       const Frame& frame) {
  int layers = 0, from = 0, to = 1;
  while (layers < maxLayers && findLayer(target, from, to, surfaces, frame)) {
    blendLayer(surfaces, frame);
    ++layers;
    from = to;
    to = 3 - to;
  }
  target.resolve();
  return static_cast<int>(surfaces.size()) * (2 * layers + 1);
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

void DepthPeeling::blendLayer(std::span<const SurfaceDraw> surfaces, const Frame& frame) {
  gl_.DepthMask(GL_FALSE);
  gl_.DepthFunc(GL_EQUAL);
  gl_.Enable(GL_BLEND);
  gl_.BlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
  for (const SurfaceDraw& surface : surfaces) shaded_.draw(surface, frame);
  gl_.Disable(GL_BLEND);
}

}  // namespace pleura::render
