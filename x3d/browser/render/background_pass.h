#pragma once

#include <pleura/x3d/browser/render/draw_list.h>
#include <pleura/x3d/browser/render/gl_objects.h>
#include <pleura/x3d/browser/render/shader_program.h>

namespace pleura::render {

/// X3D Background's sky and ground, wherever nothing has been drawn yet. A sky of one colour is left to
/// glClear.
class BackgroundPass {
 public:
  static constexpr std::size_t maxStops = 32;

  BackgroundPass(const GlFunctions& gl, const std::string& header);
  void draw(const Background& background, const Camera& camera, int width, int height) const;

 private:
  const GlFunctions& gl_;
  ShaderProgram program_;
  GlVertexArray noVertices_;
};

}  // namespace pleura::render
