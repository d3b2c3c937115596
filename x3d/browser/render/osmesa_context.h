#pragma once

#include <array>
#include <cstdint>

#include <pleura/x3d/browser/render/dynamic_library.h>
#include <pleura/x3d/browser/render/gl_context.h>

namespace pleura::render {

/// Mesa's off-screen software OpenGL. It needs neither display nor GPU; Mesa has it up to release 24.
class OsmesaContext : public GlContext {
 public:
  /// Makes a context and makes it current. Throws std::runtime_error if the library or OpenGL 3.3 is missing.
  OsmesaContext();
  ~OsmesaContext() override;

  void makeCurrent() override;
  GlFunction getProcAddress(const char* name) const override;
  Eigen::Vector2i size() const override { return {0, 0}; }

 private:
  DynamicLibrary library_;
  void* context_ = nullptr;
  std::array<std::uint32_t, 16>
      framebuffer_{};  // 4 x 4: OSMesa asks for one, though everything is drawn elsewhere
};

}  // namespace pleura::render
