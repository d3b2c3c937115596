#include <stdexcept>

#include <pleura/nodes/lung/planar/concentric_mesh.h>
#include <pleura/nodes/lung/planar/polygon.h>

namespace pleura::planar {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3i;

/// The number of point k of ring j, of 6 j points, when rings are listed from the outermost inwards.
int numberOf(int rings, int j, int k) {
  const int outside = 3 * (rings * (rings + 1) - j * (j + 1));  // sum of 6 i for i in (j, rings]
  return j == 0 ? outside : outside + k % (6 * j);
}

}  // namespace

LungMesh concentricMesh(std::span<const Vector2d> outline) {
  const int count = static_cast<int>(outline.size());
  const int rings = count / 6;
  if (count == 0 || count % 6 != 0) throw std::invalid_argument("concentric mesh: outline needs 6 R points");
  const Vector2d middle = centroid(outline);
  LungMesh mesh;
  mesh.outlineCount = count;
  for (int j = rings; j >= 1; --j) {
    for (int k = 0; k < 6 * j; ++k) {
      const int i = k * rings / j;  // point k of the ring lies (k R mod j) / j past point i of the outline
      const double part = static_cast<double>(k * rings % j) / j;
      const Vector2d& p = outline[static_cast<std::size_t>(i)];
      const Vector2d& next = outline[static_cast<std::size_t>((i + 1) % count)];
      mesh.points.emplace_back(j == rings ? p : middle + (p + part * (next - p) - middle) * j / rings);
    }
  }
  mesh.points.push_back(middle);
  for (int j = 0; j < rings; ++j) {
    for (int sector = 0; sector < 6; ++sector) {
      for (int k = 0; k <= j; ++k) {
        const int in = numberOf(rings, j, sector * j + k);
        const int out = numberOf(rings, j + 1, sector * (j + 1) + k);
        const int next = numberOf(rings, j + 1, sector * (j + 1) + k + 1);
        mesh.triangles.emplace_back(in, out, next);
        if (k < j) mesh.triangles.emplace_back(in, next, numberOf(rings, j, sector * j + k + 1));
      }
    }
  }
  for (const Vector3i& t : mesh.triangles) {
    const auto p = [&](int k) { return mesh.points[static_cast<std::size_t>(t[k])]; };
    if (!(cross(p(1) - p(0), p(2) - p(0)) > 0))
      throw std::invalid_argument("concentric mesh: outline is not seen whole from its middle");
  }
  return mesh;
}

}  // namespace pleura::planar
