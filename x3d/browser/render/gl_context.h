#pragma once

#include <memory>

#include <Eigen/Core>

#include <pleura/x3d/browser/render/gl_functions.h>

namespace pleura::render {

/// An OpenGL 3.3 core context and where it draws. Belongs to the thread that made it.
class GlContext {
 public:
  GlContext() = default;
  GlContext(const GlContext&) = delete;
  GlContext& operator=(const GlContext&) = delete;
  virtual ~GlContext() = default;

  /// Makes the context the calling thread's. Throws std::runtime_error if it can't.
  virtual void makeCurrent() = 0;

  /// Address of an OpenGL function, null if there is none.
  virtual GlFunction getProcAddress(const char* name) const = 0;

  /// Of the context's own framebuffer [pixel]; (0, 0) where it has none.
  virtual Eigen::Vector2i size() const = 0;
};

enum class OffscreenBackend {
  Automatic,  // OSMesa, else EGL
  Osmesa,     // software, no display or GPU needed
  Egl         // surfaceless: the machine's GPU where it has one
};

/// A context without a window, already current. Throws std::runtime_error that says what was tried and why it
/// failed.
std::unique_ptr<GlContext> makeOffscreenContext(OffscreenBackend backend = OffscreenBackend::Automatic);

}  // namespace pleura::render
