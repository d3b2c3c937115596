#pragma once

#include <map>
#include <string>

#include <pleura/x3d/browser/render/draw_list.h>
#include <pleura/x3d/browser/render/geometry_cache.h>
#include <pleura/x3d/browser/render/light_buffer.h>
#include <pleura/x3d/browser/render/shader_program.h>

namespace pleura::render {

/// An item with the GPU's copy of its geometry.
struct SurfaceDraw {
  const DrawItem* item;
  const GpuGeometry* gpu;

  bool transparent() const { return item->material.transparency > 0 || gpu->translucent(); }
};

/// What is the same for all items of a frame.
struct Frame {
  Eigen::Matrix4f view;
  Eigen::Matrix4f projection;
  bool parallelView;
  bool headlight;
  LightKinds lights;
};

/// Draws items with surfaceVertex and a fragment shader, in a variant for each set of features that items
/// need.
class SurfacePass {
 public:
  enum class Variants { OnlyOne, ByMaterialAndLights };

  SurfacePass(const GlFunctions& gl, std::string header, std::string fragmentSource,
              Variants variants = Variants::ByMaterialAndLights);

  void draw(const SurfaceDraw& surface, const Frame& frame);

 private:
  struct Program {
    Program(const GlFunctions& gl, const std::string& header, const std::string& fragmentSource);
    ShaderProgram shader;
    GLint projection, modelView, normalMatrix, diffuseAlpha, specularExponent, emissiveAmbient;
  };
  const Program& program(const std::string& definitions);
  void setTransform(const Program& program, const DrawItem& item, const Frame& frame) const;
  void setMaterial(const Program& program, const Material& material) const;

  const GlFunctions& gl_;
  std::string header_, fragmentSource_;
  Variants variants_;
  std::map<std::string, Program> programs_;  // by the definitions they were compiled with
};

}  // namespace pleura::render
