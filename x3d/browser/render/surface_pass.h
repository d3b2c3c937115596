#pragma once

#include <pleura/x3d/browser/render/draw_list.h>
#include <pleura/x3d/browser/render/geometry_cache.h>
#include <pleura/x3d/browser/render/shader_program.h>

namespace pleura::render {

/// An item with the GPU's copy of its geometry.
struct SurfaceDraw {
  const DrawItem* item;
  const GpuGeometry* gpu;

  bool transparent() const { return item->material.transparency > 0 || gpu->translucent(); }
};

/// What is the same for all items of a frame.
struct FrameUniforms {
  Eigen::Matrix4f view;
  Eigen::Matrix4f projection;
  bool parallelView;
  int lightCount;
  bool headlight;  // the last light
};

/// Draws items with surfaceVertex and a fragment shader: shaded, or only for their depth.
class SurfacePass {
 public:
  SurfacePass(const GlFunctions& gl, const std::string& header, const char* fragmentSource);

  /// Makes the shaders current for a frame.
  void begin(const FrameUniforms& frame);
  void draw(const SurfaceDraw& surface);

 private:
  void setMaterial(const DrawItem& item, const GpuGeometry& gpu) const;

  const GlFunctions& gl_;
  ShaderProgram program_;
  Eigen::Matrix4f view_;
  std::uint32_t alwaysOn_ = 0;  // the headlight's bit
  struct {
    GLint projection, modelView, normalMatrix, lightCount, lightMask, diffuseAlpha, specularExponent,
        emissiveAmbient, lit, faceted, colored, parallelView;
  } at_;
};

}  // namespace pleura::render
