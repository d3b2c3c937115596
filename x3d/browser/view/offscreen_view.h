#pragma once

#include <memory>

#include <pleura/x3d/browser/render/gl_context.h>
#include <pleura/x3d/browser/render/image.h>
#include <pleura/x3d/browser/render/renderer.h>
#include <pleura/x3d/browser/view/scene_view.h>

namespace pleura {

/// Pictures of a scene without a window.
class OffscreenView {
 public:
  /// Throws std::runtime_error when no OpenGL can be had.
  OffscreenView(Scene& scene, int width, int height)
      : view_(scene),
        context_(render::makeOffscreenContext()),
        renderer_(*context_),
        width_(width),
        height_(height) {}

  SceneView& view() { return view_; }

  /// The scene as it is now.
  render::Image picture() {
    renderer_.draw(view_.update(), width_, height_);
    return renderer_.readImage();
  }

 private:
  SceneView view_;
  std::unique_ptr<render::GlContext> context_;
  render::Renderer renderer_;
  int width_, height_;
};

}  // namespace pleura
