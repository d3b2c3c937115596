#include <algorithm>
#include <stdexcept>

#include <fmt/format.h>

#include <pleura/x3d/browser/render/render_target.h>

namespace pleura::render {

int supportedSamples(const GlFunctions& gl, int wanted) {
  GLint color = 1, depth = 1;
  gl.GetIntegerv(GL_MAX_COLOR_TEXTURE_SAMPLES, &color);
  gl.GetIntegerv(GL_MAX_DEPTH_TEXTURE_SAMPLES, &depth);
  return std::min({wanted, color, depth});
}

RenderTarget::RenderTarget(const GlFunctions& gl, int width, int height, int samples)
    : gl_(gl),
      width_(width),
      height_(height),
      resolvedColor_(gl),
      color_(gl),
      depths_{GlTexture(gl), GlTexture(gl), GlTexture(gl)},
      multisampled_{GlFramebuffer(gl), GlFramebuffer(gl), GlFramebuffer(gl)},
      resolved_(gl) {
  gl_.BindTexture(GL_TEXTURE_2D_MULTISAMPLE, color_);
  gl_.TexImage2DMultisample(GL_TEXTURE_2D_MULTISAMPLE, samples, GL_RGBA8, width, height, GL_TRUE);
  for (int i = 0; i < 3; ++i) attach(i, samples);

  gl_.BindRenderbuffer(GL_RENDERBUFFER, resolvedColor_);
  gl_.RenderbufferStorageMultisample(GL_RENDERBUFFER, 0, GL_RGBA8, width, height);
  gl_.BindFramebuffer(GL_FRAMEBUFFER, resolved_);
  gl_.FramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, resolvedColor_);
  check();
}

void RenderTarget::attach(int i, int samples) {
  gl_.BindTexture(GL_TEXTURE_2D_MULTISAMPLE, depths_[i]);
  gl_.TexImage2DMultisample(GL_TEXTURE_2D_MULTISAMPLE, samples, GL_DEPTH_COMPONENT32F, width_, height_,
                            GL_TRUE);
  gl_.BindFramebuffer(GL_FRAMEBUFFER, multisampled_[i]);
  gl_.FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D_MULTISAMPLE, color_, 0);
  gl_.FramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D_MULTISAMPLE, depths_[i], 0);
  check();
}

void RenderTarget::check() const {
  const GLenum status = gl_.CheckFramebufferStatus(GL_FRAMEBUFFER);
  if (status != GL_FRAMEBUFFER_COMPLETE)
    throw std::runtime_error(
        fmt::format("OpenGL refuses a framebuffer of {} x {} (0x{:x})", width_, height_, status));
}

void RenderTarget::resolve() const {
  gl_.BindFramebuffer(GL_READ_FRAMEBUFFER, multisampled_[0]);
  gl_.BindFramebuffer(GL_DRAW_FRAMEBUFFER, resolved_);
  gl_.BlitFramebuffer(0, 0, width_, height_, 0, 0, width_, height_, GL_COLOR_BUFFER_BIT, GL_NEAREST);
}

Image RenderTarget::read() const {
  std::vector<std::uint8_t> rgba(static_cast<std::size_t>(width_) * height_ * 4);
  gl_.BindFramebuffer(GL_READ_FRAMEBUFFER, resolved_);
  gl_.ReadPixels(0, 0, width_, height_, GL_RGBA, GL_UNSIGNED_BYTE, rgba.data());
  Image image = makeImage(width_, height_);
  for (int y = 0; y < height_; ++y) {
    const std::uint8_t* from = rgba.data() + static_cast<std::size_t>(height_ - 1 - y) * width_ * 4;
    std::uint8_t* to = image.at(0, y);
    for (int x = 0; x < width_; ++x, from += 4, to += 3) std::copy_n(from, 3, to);
  }
  return image;
}

void RenderTarget::present() const {
  gl_.BindFramebuffer(GL_READ_FRAMEBUFFER, resolved_);
  gl_.BindFramebuffer(GL_DRAW_FRAMEBUFFER, 0);
  gl_.BlitFramebuffer(0, 0, width_, height_, 0, 0, width_, height_, GL_COLOR_BUFFER_BIT, GL_NEAREST);
}

}  // namespace pleura::render
