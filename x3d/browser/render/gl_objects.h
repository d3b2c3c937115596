#pragma once

#include <utility>

#include <pleura/x3d/browser/render/gl_functions.h>

namespace pleura::render {

/// Owns one OpenGL object; the context is current when it is made and when it goes.
template <auto generate, auto remove>
class GlObject {
 public:
  explicit GlObject(const GlFunctions& gl) : gl_(&gl) { (gl.*generate)(1, &id_); }
  GlObject(GlObject&& other) noexcept : gl_(other.gl_), id_(std::exchange(other.id_, 0)) {}
  GlObject& operator=(GlObject&& other) noexcept {
    std::swap(gl_, other.gl_);
    std::swap(id_, other.id_);
    return *this;
  }
  ~GlObject() {
    if (id_) (gl_->*remove)(1, &id_);
  }

  operator GLuint() const { return id_; }

 private:
  const GlFunctions* gl_;
  GLuint id_ = 0;
};

using GlBuffer = GlObject<&GlFunctions::GenBuffers, &GlFunctions::DeleteBuffers>;
using GlVertexArray = GlObject<&GlFunctions::GenVertexArrays, &GlFunctions::DeleteVertexArrays>;
using GlTexture = GlObject<&GlFunctions::GenTextures, &GlFunctions::DeleteTextures>;
using GlRenderbuffer = GlObject<&GlFunctions::GenRenderbuffers, &GlFunctions::DeleteRenderbuffers>;
using GlFramebuffer = GlObject<&GlFunctions::GenFramebuffers, &GlFunctions::DeleteFramebuffers>;
using GlQuery = GlObject<&GlFunctions::GenQueries, &GlFunctions::DeleteQueries>;

}  // namespace pleura::render
