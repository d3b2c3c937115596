#pragma once

#include <EGL/egl.h>

#include <pleura/x3d/browser/render/dynamic_library.h>
#include <pleura/x3d/browser/render/gl_context.h>

namespace pleura::render {

/// OpenGL through EGL with no surface (EGL_MESA_platform_surfaceless): the GPU where there is one, else
/// Mesa's software.
class EglContext : public GlContext {
 public:
  /// Makes a context and makes it current. Throws std::runtime_error if the library or OpenGL 3.3 is missing.
  EglContext();
  ~EglContext() override;

  void makeCurrent() override;
  GlFunction getProcAddress(const char* name) const override;
  Eigen::Vector2i size() const override { return {0, 0}; }

 private:
  DynamicLibrary library_;
  EGLDisplay display_ = EGL_NO_DISPLAY;
  EGLContext context_ = EGL_NO_CONTEXT;
};

}  // namespace pleura::render
