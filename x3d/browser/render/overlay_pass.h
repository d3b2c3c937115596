#pragma once

#include <map>
#include <span>
#include <tuple>

#include <pleura/x3d/browser/render/draw_list.h>
#include <pleura/x3d/browser/render/font.h>
#include <pleura/x3d/browser/render/gl_objects.h>
#include <pleura/x3d/browser/render/shader_program.h>

namespace pleura::render {

/// Draws labels and status over the resolved picture. Text that stays from frame to frame is rasterised once.
class OverlayPass {
 public:
  OverlayPass(const GlFunctions& gl, const std::string& header);
  void draw(std::span<const OverlayText> texts, int width, int height);

 private:
  struct Label {
    GlTexture texture;
    int width, height;
    bool used;
  };
  using Key = std::tuple<std::string, int, Justify>;
  const Label& find(const OverlayText& text);
  Label rasterize(const Key& key);

  const GlFunctions& gl_;
  ShaderProgram program_;
  GlVertexArray noVertices_;
  std::unique_ptr<Font> font_;  // opened when there is text
  std::map<Key, Label> labels_;
};

}  // namespace pleura::render
