#include <cmath>

#include <pleura/x3d/browser/render/overlay_pass.h>
#include <pleura/x3d/browser/render/shaders.h>

namespace pleura::render {
namespace {

float fraction(Justify justify) { return static_cast<float>(justify) / 2; }

}  // namespace

OverlayPass::OverlayPass(const GlFunctions& gl, const std::string& header)
    : gl_(gl), program_(gl, header, shaders::overlayVertex, shaders::overlayFragment), noVertices_(gl) {}

void OverlayPass::draw(std::span<const OverlayText> texts, int width, int height) {
  if (texts.empty()) return;
  for (auto& [key, label] : labels_) label.used = false;
  program_.use();
  gl_.Uniform2f(program_.uniform("picture"), static_cast<float>(width), static_cast<float>(height));
  gl_.ActiveTexture(GL_TEXTURE0);
  gl_.BindVertexArray(noVertices_);
  gl_.Disable(GL_DEPTH_TEST);
  gl_.Disable(GL_CULL_FACE);
  gl_.Enable(GL_BLEND);
  gl_.BlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
  for (const OverlayText& text : texts) {
    const Label& label = find(text);
    const auto w = static_cast<float>(label.width), h = static_cast<float>(label.height);
    const Eigen::Vector4f rectangle(std::round(text.x - fraction(text.justify) * w), std::round(text.y), w,
                                    h);
    gl_.Uniform4fv(program_.uniform("rectangle"), 1, rectangle.data());
    gl_.Uniform4fv(program_.uniform("color"), 1, text.color.data());
    gl_.BindTexture(GL_TEXTURE_2D, label.texture);
    gl_.DrawArrays(GL_TRIANGLE_STRIP, 0, 4);
  }
  gl_.Disable(GL_BLEND);
  std::erase_if(labels_, [](const auto& entry) { return !entry.second.used; });
}

const OverlayPass::Label& OverlayPass::find(const OverlayText& text) {
  const Key key(text.text, static_cast<int>(std::lround(text.size)), text.justify);
  auto found = labels_.find(key);
  if (found == labels_.end()) found = labels_.emplace(key, rasterize(key)).first;
  found->second.used = true;
  return found->second;
}

OverlayPass::Label OverlayPass::rasterize(const Key& key) {
  if (!font_) font_ = std::make_unique<Font>(findFont(FontFamily::Sans, false, false));
  const auto& [text, size, justify] = key;
  const TextBitmap bitmap = font_->rasterize(text, size, fraction(justify));
  Label label{GlTexture(gl_), bitmap.width, bitmap.height, true};
  gl_.BindTexture(GL_TEXTURE_2D, label.texture);
  gl_.PixelStorei(GL_UNPACK_ALIGNMENT, 1);
  gl_.TexImage2D(GL_TEXTURE_2D, 0, GL_R8, bitmap.width, bitmap.height, 0, GL_RED, GL_UNSIGNED_BYTE,
                 bitmap.coverage.data());
  gl_.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  gl_.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  return label;
}

}  // namespace pleura::render
