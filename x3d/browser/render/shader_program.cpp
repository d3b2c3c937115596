#include <stdexcept>

#include <pleura/x3d/browser/render/shader_program.h>

namespace pleura::render {
namespace {

constexpr GLsizei logSize = 2048;

GLuint compile(const GlFunctions& gl, GLenum stage, const std::string& header, const char* source) {
  const GLuint shader = gl.CreateShader(stage);
  const char* parts[] = {header.c_str(), source};
  gl.ShaderSource(shader, 2, parts, nullptr);
  gl.CompileShader(shader);
  GLint done = 0;
  gl.GetShaderiv(shader, GL_COMPILE_STATUS, &done);
  if (done) return shader;
  char log[logSize] = {};
  gl.GetShaderInfoLog(shader, logSize, nullptr, log);
  gl.DeleteShader(shader);
  throw std::runtime_error(std::string("shader does not compile: ") + log);
}

}  // namespace

ShaderProgram::ShaderProgram(const GlFunctions& gl, const std::string& header, const char* vertexSource,
                             const char* fragmentSource)
    : gl_(gl), id_(gl.CreateProgram()) {
  for (const auto& [stage, source] :
       {std::pair{GL_VERTEX_SHADER, vertexSource}, std::pair{GL_FRAGMENT_SHADER, fragmentSource}}) {
    const GLuint shader = compile(gl, static_cast<GLenum>(stage), header, source);
    gl.AttachShader(id_, shader);
    gl.DeleteShader(shader);
  }
  gl.LinkProgram(id_);
  GLint done = 0;
  gl.GetProgramiv(id_, GL_LINK_STATUS, &done);
  if (done) return;
  char log[logSize] = {};
  gl.GetProgramInfoLog(id_, logSize, nullptr, log);
  throw std::runtime_error(std::string("shaders do not link: ") + log);
}

ShaderProgram::~ShaderProgram() { gl_.DeleteProgram(id_); }

void ShaderProgram::use() const { gl_.UseProgram(id_); }

GLint ShaderProgram::uniform(const char* name) const { return gl_.GetUniformLocation(id_, name); }

void ShaderProgram::bindBlock(const char* name, GLuint binding) const {
  const GLuint block = gl_.GetUniformBlockIndex(id_, name);
  if (block != GL_INVALID_INDEX) gl_.UniformBlockBinding(id_, block, binding);
}

}  // namespace pleura::render
