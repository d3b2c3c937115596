#pragma once

#include <memory>

#include <pleura/x3d/browser/render/draw_list.h>
#include <pleura/x3d/browser/render/gl_context.h>
#include <pleura/x3d/browser/render/image.h>

namespace pleura::render {

/// What the last draw() did.
struct RenderStats {
  int draws = 0;    // draw calls for items
  int uploads = 0;  // vertex and index streams sent to the GPU
};

struct RendererOptions {
  int samples = 4;            // for a smooth edge; fewer where the OpenGL has no more
  bool depthPeeling = false;  // also where OpenGL 4.3 allows the faster FragmentLists
};

/// Draws DrawLists off screen with X3D's lighting, 4x multisampled; transparent surfaces in the right order
/// for every sample, whatever their shape and order in the list (see transparency_pass.h).
class Renderer {
 public:
  /// `context` outlives the renderer. Throws std::runtime_error if its OpenGL is not fit,
  /// std::invalid_argument for options.samples below 1.
  explicit Renderer(GlContext& context, const RendererOptions& options = {});
  ~Renderer();

  /// Draws into the renderer's own picture. Throws std::invalid_argument that names the bad value: NaN, an
  /// index outside its geometry, sizes that do not fit, a side outside [1, 8192]; the picture then keeps its
  /// last content.
  void draw(const DrawList& list, int width, int height);

  /// The picture of the last draw(). Throws std::logic_error before the first.
  Image readImage();

  /// Copies the picture to the context's own framebuffer, its lower left corner first; the window then swaps
  /// it to the front.
  void present();

  const RenderStats& stats() const;

 private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace pleura::render
