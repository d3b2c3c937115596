#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include <pleura/nodes/deformable/contact/dent.h>
#include <pleura/nodes/deformable/mesh/measures.h>
#include <pleura/nodes/deformable/mesh/triangle_geometry.h>

namespace pleura {

namespace {

using Eigen::Vector3d;
using Eigen::Vector3f;
using Eigen::Vector3i;

constexpr double kReach = 6;  // [contact radii] beyond which nothing moves

struct Place {
  Vector3i triangle;
  Vector3d weights;
  double edge = 0;  // [m], the triangle's longest
};

/// The triangle that has the point on it or is nearest to it; none farther than its own size.
std::optional<Place> placeOf(const Vector3d& point, std::span<const Vector3i> triangles,
                             std::span<const Vector3f> points) {
  std::optional<Place> best;
  double least = std::numeric_limits<double>::infinity();
  for (const Vector3i& triangle : triangles) {
    Corners corners;
    for (int k = 0; k < 3; ++k) corners.col(k) = points[triangle[k]].cast<double>();
    const double edge =
        std::max({(corners.col(0) - corners.col(1)).norm(), (corners.col(1) - corners.col(2)).norm(),
                  (corners.col(2) - corners.col(0)).norm()});
    if (!((corners.col(0) - point).norm() <= 2 * edge)) continue;
    const TrianglePoint nearest = closestPointOnTriangle(corners, point);
    if (nearest.squaredDistance >= least || nearest.squaredDistance > edge * edge) continue;
    least = nearest.squaredDistance;
    best = Place{triangle, nearest.weights, edge};
  }
  return best;
}

/// The profile, led to 0 at the end of its reach.
double windowed(double rho) {
  const double rest = 1 - (rho / kReach) * (rho / kReach);
  return rest > 0 ? hertzProfile(rho) * rest * rest : 0;
}

}  // namespace

double hertzProfile(double rho) {
  // u / delta = 1 - rho^2 / 2 inside, ((2 - rho^2) asin(1 / rho) + sqrt(rho^2 - 1)) / pi outside
  if (rho <= 1) return 1 - rho * rho / 2;
  return ((2 - rho * rho) * std::asin(1 / rho) + std::sqrt(rho * rho - 1)) / std::numbers::pi;
}

bool press(const Dent& dent, std::span<const Vector3i> triangles, std::span<Vector3f> points) {
  if (!std::isfinite(dent.depth) || dent.depth <= 0 || !isFinite(dent.point) || !isFinite(dent.normal))
    return false;
  const Vector3d middle = dent.point.cast<double>();
  const auto place = placeOf(middle, triangles, points);
  if (!place) return false;
  const double a = std::max(std::sqrt(dent.radius * dent.depth), place->edge);  // a^2 = R delta (Hertz)
  const auto part = [&](const Vector3f& p) { return windowed((p.cast<double>() - middle).norm() / a); };
  double atMiddle = 0;
  for (int k = 0; k < 3; ++k) atMiddle += place->weights[k] * part(points[place->triangle[k]]);
  const Vector3d most = -dent.depth / atMiddle * dent.normal.cast<double>();
  for (Vector3f& p : points) p += (part(p) * most).cast<float>();
  return true;
}

}  // namespace pleura
