#include <algorithm>
#include <cmath>

#include <pleura/nodes/deformable/mesh/measures.h>
#include <pleura/nodes/deformable/mesh/surface_query.h>
#include <pleura/x3d/browser/tradeoff/shape_error.h>

namespace pleura {

ShapeError shapeError(std::span<const std::vector<Vec3f>> shapes,
                      std::span<const std::vector<Vec3f>> reference,
                      std::span<const Eigen::Vector3i> triangles, std::span<const int> driven) {
  ShapeError error;
  if (reference.empty()) return error;
  std::vector<bool> isDriven(reference[0].size(), false);
  for (const int i : driven) isDriven[static_cast<std::size_t>(i)] = true;
  std::vector<double> distances;
  double squares = 0;
  for (std::size_t k = 0; k < shapes.size(); ++k) {
    for (std::size_t i = 0; i < shapes[k].size(); ++i) {
      if (isDriven[i]) continue;
      const double distance = (shapes[k][i] - reference[k][i]).cast<double>().norm();
      distances.push_back(distance);
      squares += distance * distance;
    }
    const double volume = signedVolume(reference[k], triangles);
    const double excess = signedVolume(shapes[k], triangles) / volume - 1;
    if (std::abs(excess) > std::abs(error.volume)) error.volume = excess;
  }
  if (distances.empty()) return error;
  std::sort(distances.begin(), distances.end());
  error.rms = std::sqrt(squares / static_cast<double>(distances.size()));
  error.percentile95 = distances[(distances.size() - 1) * 95 / 100];
  error.most = distances.back();
  return error;
}

void measureContact(const Neighbours& neighbours, std::span<const std::vector<Vec3f>> closed,
                    std::span<const std::vector<Vec3f>> beside, ShapeError& error) {
  constexpr double kNear = 0.01;  // [m]
  SurfaceQuery surface(neighbours.closed.points, neighbours.closed.triangles);
  std::vector<std::pair<std::size_t, double>> near;  // point, distance at rest
  for (std::size_t i = 0; i < neighbours.beside.size(); ++i) {
    const Eigen::Vector3d p = neighbours.beside[i].cast<double>();
    if (surface.closestPointWithin(p, kNear)) near.emplace_back(i, surface.signedDistance(p));
  }
  for (std::size_t k = 0; k < closed.size(); ++k) {
    surface.refit(closed[k]);
    for (const auto& [i, atRest] : near) {
      const double distance = surface.signedDistance(beside[k][i].cast<double>());
      error.gap = std::max(error.gap, distance - std::max(atRest, 0.0));
      error.penetration = std::max(error.penetration, std::min(atRest, 0.0) - distance);
    }
  }
}

}  // namespace pleura
