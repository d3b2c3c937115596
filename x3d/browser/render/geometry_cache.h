#pragma once

#include <map>
#include <memory>

#include <pleura/x3d/browser/render/draw_list.h>
#include <pleura/x3d/browser/render/gl_objects.h>

namespace pleura::render {

/// A Geometry's streams on the GPU, each sent again only when its revision or size has changed.
class GpuGeometry {
 public:
  explicit GpuGeometry(const GlFunctions& gl);

  /// Brings the streams up to date and gives how many were sent. Throws std::invalid_argument, and keeps the
  /// stream sent before, if sizes do not fit, a value is not finite or an index is outside.
  int update(const Geometry& geometry);

  void draw(Primitive primitive) const;
  bool hasNormals() const { return normals_.size > 0; }
  bool hasColors() const { return colors_.size > 0; }
  bool translucent() const { return translucent_; }  // some colour has alpha below 1

 private:
  struct Stream {
    GlBuffer buffer;
    std::uint64_t revision = 0;
    std::size_t size = 0;
    bool sent = false;
  };
  template <class Value>
  bool changed(const Stream& stream, std::span<const Value> values, std::uint64_t revision) const;
  template <class Value>
  bool sendVertices(Stream& stream, std::span<const Value> values, std::uint64_t revision, GLuint attribute,
                    const char* name);
  bool sendIndices(const Geometry& geometry);

  const GlFunctions& gl_;
  GlVertexArray vertexArray_;
  Stream positions_, normals_, colors_, indices_;
  std::uint32_t largestIndex_ = 0;
  bool translucent_ = false;
};

/// The GPU's copies of the geometries drawn, each kept as long as its Geometry lives.
class GeometryCache {
 public:
  explicit GeometryCache(const GlFunctions& gl) : gl_(gl) {}

  GpuGeometry& find(const Geometry& geometry);

  /// Drops the copies of geometries that are gone.
  void collect();

 private:
  struct Entry {
    std::weak_ptr<const char> identity;  // keeps the address, and so the key, from being used again
    GpuGeometry gpu;
  };
  const GlFunctions& gl_;
  std::map<const char*, Entry> entries_;
};

}  // namespace pleura::render
