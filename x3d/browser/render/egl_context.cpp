#include <stdexcept>

#include <EGL/egl.h>
#include <EGL/eglext.h>

#include <pleura/x3d/browser/render/egl_context.h>

namespace pleura::render {
namespace {

void requireEgl(bool done, const char* what) {
  if (!done) throw std::runtime_error(what);
}

}  // namespace

EglContext::EglContext() : library_({"libEGL.so.1", "libEGL.so"}) {
  const auto getPlatformDisplay =
      reinterpret_cast<PFNEGLGETPLATFORMDISPLAYEXTPROC>(getProcAddress("eglGetPlatformDisplayEXT"));
  requireEgl(getPlatformDisplay != nullptr, "no eglGetPlatformDisplayEXT");
  display_ = getPlatformDisplay(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
  requireEgl(display_ != EGL_NO_DISPLAY, "no surfaceless display");
  requireEgl(library_.function<PFNEGLINITIALIZEPROC>("eglInitialize")(display_, nullptr, nullptr),
             "eglInitialize failed");
  requireEgl(library_.function<PFNEGLBINDAPIPROC>("eglBindAPI")(EGL_OPENGL_API), "no desktop OpenGL");

  const EGLint any[] = {EGL_SURFACE_TYPE, 0, EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT, EGL_NONE};
  EGLConfig config = nullptr;
  EGLint count = 0;
  library_.function<PFNEGLCHOOSECONFIGPROC>("eglChooseConfig")(display_, any, &config, 1, &count);
  requireEgl(count > 0, "no configuration for OpenGL");
  const EGLint core33[] = {EGL_CONTEXT_MAJOR_VERSION,
                           3,
                           EGL_CONTEXT_MINOR_VERSION,
                           3,
                           EGL_CONTEXT_OPENGL_PROFILE_MASK,
                           EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                           EGL_NONE};
  context_ = library_.function<PFNEGLCREATECONTEXTPROC>("eglCreateContext")(display_, config, EGL_NO_CONTEXT,
                                                                            core33);
  requireEgl(context_ != EGL_NO_CONTEXT, "no OpenGL 3.3 core context");
  makeCurrent();
}

EglContext::~EglContext() {
  library_.function<PFNEGLMAKECURRENTPROC>("eglMakeCurrent")(display_, EGL_NO_SURFACE, EGL_NO_SURFACE,
                                                             EGL_NO_CONTEXT);
  library_.function<PFNEGLDESTROYCONTEXTPROC>("eglDestroyContext")(display_, context_);
}

void EglContext::makeCurrent() {
  requireEgl(library_.function<PFNEGLMAKECURRENTPROC>("eglMakeCurrent")(display_, EGL_NO_SURFACE,
                                                                        EGL_NO_SURFACE, context_),
             "eglMakeCurrent failed");
}

GlFunction EglContext::getProcAddress(const char* name) const {
  return library_.function<PFNEGLGETPROCADDRESSPROC>("eglGetProcAddress")(name);
}

}  // namespace pleura::render
