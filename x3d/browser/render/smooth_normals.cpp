#include <algorithm>

#include <Eigen/Geometry>

#include <pleura/x3d/browser/render/smooth_normals.h>

namespace pleura::render {

void smoothNormals(std::span<const Eigen::Vector3f> positions, std::span<const std::uint32_t> triangles,
                   std::span<Eigen::Vector3f> out) {
  std::fill(out.begin(), out.end(), Eigen::Vector3f::Zero());
  // n_i = sum over triangles (i, j, k) of (x_j - x_i) x (x_k - x_i): twice the area times the facet's normal.
  for (std::size_t t = 0; t + 2 < triangles.size(); t += 3) {
    const std::uint32_t i = triangles[t], j = triangles[t + 1], k = triangles[t + 2];
    const Eigen::Vector3f n = (positions[j] - positions[i]).cross(positions[k] - positions[i]);
    out[i] += n;
    out[j] += n;
    out[k] += n;
  }
  for (Eigen::Vector3f& n : out) n = n.stableNormalized();
}

}  // namespace pleura::render
