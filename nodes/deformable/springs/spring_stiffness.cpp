#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <Eigen/Geometry>

#include <pleura/nodes/deformable/mesh/measures.h>
#include <pleura/nodes/deformable/mesh/topology.h>
#include <pleura/nodes/deformable/springs/spring_stiffness.h>

namespace pleura {
namespace {

bool isBefore(const Eigen::Vector2i& a, const Eigen::Vector2i& b) {
  return a[0] != b[0] ? a[0] < b[0] : a[1] < b[1];
}

}  // namespace

std::vector<double> membraneStiffness(std::span<const Eigen::Vector3f> rest,
                                      std::span<const Eigen::Vector3i> triangles,
                                      std::span<const Eigen::Vector2i> edges, double modulus) {
  constexpr double kSoftest = 1e-3, kStiffest = 1e3;
  if (!std::isfinite(modulus) || modulus <= 0)
    throw std::invalid_argument("springs: the modulus of a membrane must be above 0, and finite");
  requireFinite(rest);
  requireIndicesInRange(rest.size(), triangles);
  const auto point = [&](int i) -> Eigen::Vector3d {
    return rest[static_cast<std::size_t>(i)].cast<double>();
  };
  std::vector<double> area(edges.size(), 0);
  for (const Eigen::Vector3i& t : triangles) {
    const double a = (point(t[1]) - point(t[0])).cross(point(t[2]) - point(t[0])).norm() / 2;
    for (int side = 0; side < 3; ++side) {
      const auto [low, high] = std::minmax(t[side], t[(side + 1) % 3]);
      const Eigen::Vector2i edge(low, high);
      const auto found = std::lower_bound(edges.begin(), edges.end(), edge, isBefore);
      if (found != edges.end() && *found == edge) area[static_cast<std::size_t>(found - edges.begin())] += a;
    }
  }
  std::vector<double> stiffness(edges.size());
  for (std::size_t e = 0; e < edges.size(); ++e) {
    const double squaredLength = (point(edges[e][1]) - point(edges[e][0])).squaredNorm();
    // compared as products: a length may be 0
    const double ratio = area[e] >= kStiffest * squaredLength ? kStiffest : area[e] / squaredLength;
    stiffness[e] = modulus * std::max(kSoftest, ratio);
  }
  return stiffness;
}

}  // namespace pleura
