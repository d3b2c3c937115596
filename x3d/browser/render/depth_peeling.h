#pragma once

#include <functional>
#include <span>

#include <pleura/x3d/browser/render/render_target.h>
#include <pleura/x3d/browser/render/surface_pass.h>

namespace pleura {

/// Transparent surfaces in the right order for every sample (Everitt 2001, from the back): per layer, the
/// farthest depth in front of the layer before is found, then what stands at that depth is shaded and blended
/// over the picture. Sorting objects or triangles fails on lungs: concave, two-sided, and with pleurae and
/// diaphragm lying millimetres apart; weighted blending gives the wrong colour. Each visible surface is
/// shaded once, so layers cost little.
class DepthPeeling {
 public:
  /// Beyond this many surfaces behind one another the nearest are left out.
  static constexpr int maxLayers = 64;

  DepthPeeling(const GlFunctions& gl, const std::string& header);

  /// Blends the surfaces over what `target` holds, with `shaded` as the pass that gives their colour. Gives
  /// the number of layers.
  int draw(const RenderTarget& target, std::span<const SurfaceDraw> surfaces, const Frame& frame,
           SurfacePass& shaded);

 private:
  bool findLayer(const RenderTarget& target, int from, int to, std::span<const SurfaceDraw> surfaces,
                 const Frame& frame);
  void blendLayer(std::span<const SurfaceDraw> surfaces, const Frame& frame, SurfacePass& shaded) const;

  const GlFunctions& gl_;
  SurfacePass peel_;
  GlQuery anything_;
};

}  // namespace pleura
