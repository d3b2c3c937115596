#pragma once

#include <optional>

#include <pleura/x3d/browser/render/gl_objects.h>
#include <pleura/x3d/browser/render/image.h>

namespace pleura::render {

/// The most samples that the OpenGL has for both colour and depth textures, up to `wanted`.
int supportedSamples(const GlFunctions& gl, int wanted);

/// The framebuffers of one picture size: multisampled colour with three depth textures (opaque surfaces, and
/// two that depth peeling uses in turns), and the resolved picture of one sample.
class RenderTarget {
 public:
  /// `samples` beyond what the OpenGL has become the most it has. Throws std::runtime_error if it refuses the
  /// framebuffers.
  RenderTarget(const GlFunctions& gl, int width, int height, int samples);

  int width() const { return width_; }
  int height() const { return height_; }

  /// Draws from here on go to the colour buffer with depth texture i: 0 opaque, 1 and 2 the peels'.
  void bind(int i) const { gl_.BindFramebuffer(GL_FRAMEBUFFER, multisampled_[i]); }

  /// Depth texture i, GL_TEXTURE_2D_MULTISAMPLE.
  GLuint depth(int i) const { return depths_[i]; }

  /// The multisampled colours, GL_TEXTURE_2D_MULTISAMPLE.
  GLuint color() const { return color_; }

  /// Averages the samples into the resolved picture and makes that the one drawn to.
  void resolve() const;

  /// The resolved picture.
  Image read() const;

  /// Copies the resolved picture to framebuffer 0, lower left corners together.
  void present() const;

 private:
  void attach(int i, int samples);
  void check() const;

  const GlFunctions& gl_;
  int width_, height_;
  GlRenderbuffer resolvedColor_;
  GlTexture color_, depths_[3];
  GlFramebuffer multisampled_[3];
  GlFramebuffer resolved_;
};

}  // namespace pleura::render
