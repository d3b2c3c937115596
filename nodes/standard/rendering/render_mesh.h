#pragma once

#include <cstdint>
#include <vector>

#include <pleura/fields/values.h>

namespace pleura {

/// A geometry as a renderer takes it: flat arrays, one entry a vertex, and indices into them. A revision
/// grows whenever what it stands for has changed, so that any number of readers each see what is new to them.
struct RenderMesh {
  enum class Primitive { triangles, lines, points };

  Primitive primitive = Primitive::triangles;
  std::vector<Vec3f> positions;        // [m]
  std::vector<Vec3f> normals;          // unit vectors; empty for lines and points
  std::vector<RGBA> colors;            // empty: the material's
  std::vector<std::uint32_t> indices;  // three a triangle, two a line, one a point
  bool solid = true;                   // back faces are not drawn
  bool ccw = true;                     // front faces are counterclockwise
  std::uint64_t topologyRevision = 0;  // of the indices and of how many vertices there are
  std::uint64_t vertexRevision = 0;    // of positions, normals and colours
};

}  // namespace pleura
