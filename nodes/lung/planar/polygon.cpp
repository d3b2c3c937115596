#include <pleura/nodes/lung/planar/polygon.h>

namespace pleura::planar {

using Eigen::Vector2d;

double areaForm(std::span<const Vector2d> p, std::span<const Vector2d> r) {
  double twice = 0;
  for (std::size_t k = 0; k + 1 < p.size(); ++k) twice += cross(p[k], r[k + 1]);
  return (twice + cross(p.back(), r.front())) / 2;
}

double area(std::span<const Vector2d> ring) { return areaForm(ring, ring); }

Vector2d areaGradient(std::span<const Vector2d> ring, std::size_t k) {
  const std::size_t n = ring.size();
  const Vector2d across = ring[k + 1 < n ? k + 1 : 0] - ring[k > 0 ? k - 1 : n - 1];
  return Vector2d(across.y(), -across.x()) / 2;
}

Vector2d centroid(std::span<const Vector2d> ring) {
  Vector2d sum = Vector2d::Zero();
  double twice = 0;
  for (std::size_t k = 0; k < ring.size(); ++k) {
    const Vector2d a = ring[k] - ring[0];
    const Vector2d b = ring[(k + 1) % ring.size()] - ring[0];
    sum += cross(a, b) * (a + b);
    twice += cross(a, b);
  }
  return ring[0] + sum / (3 * twice);
}

}  // namespace pleura::planar
