#pragma once

#include <string>

#include <pleura/x3d/browser/render/gl_functions.h>

namespace pleura::render {

/// A linked vertex and fragment shader.
class ShaderProgram {
 public:
  /// Each source follows `header`, which holds the #version line. Throws std::runtime_error with the
  /// compiler's log.
  ShaderProgram(const GlFunctions& gl, const std::string& header, const char* vertexSource,
                const char* fragmentSource);
  ~ShaderProgram();
  ShaderProgram(const ShaderProgram&) = delete;
  ShaderProgram& operator=(const ShaderProgram&) = delete;

  void use() const;

  /// Location of a uniform; -1, which OpenGL ignores, where the compiler has dropped it.
  GLint uniform(const char* name) const;

  /// Ties a uniform block to a binding point, if the shaders use it.
  void bindBlock(const char* name, GLuint binding) const;

 private:
  const GlFunctions& gl_;
  GLuint id_ = 0;
};

}  // namespace pleura::render
