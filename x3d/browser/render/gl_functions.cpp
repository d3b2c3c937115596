#include <stdexcept>

#include <fmt/format.h>

#include <pleura/x3d/browser/render/gl_context.h>
#include <pleura/x3d/browser/render/gl_functions.h>

namespace pleura::render {
namespace {

template <class Function>
Function load(const GlContext& context, const char* name) {
  const auto function = reinterpret_cast<Function>(context.getProcAddress(name));
  if (!function) throw std::runtime_error(fmt::format("this OpenGL has no {}", name));
  return function;
}

}  // namespace

GlFunctions loadGlFunctions(const GlContext& context) {
  GlFunctions gl;
#define PLEURA_GL_LOAD(type, name) gl.name = load<type>(context, "gl" #name);
  PLEURA_GL_FUNCTIONS(PLEURA_GL_LOAD)
  GLint major = 0, minor = 0;
  gl.GetIntegerv(GL_MAJOR_VERSION, &major);
  gl.GetIntegerv(GL_MINOR_VERSION, &minor);
  gl.version = 10 * major + minor;
  if (gl.version < 33)
    throw std::runtime_error(fmt::format("OpenGL 3.3 is needed, this is {}.{}", major, minor));
  if (gl.version < 43) return gl;
  PLEURA_GL_43_FUNCTIONS(PLEURA_GL_LOAD)
#undef PLEURA_GL_LOAD
  return gl;
}

}  // namespace pleura::render
