#include <pleura/nodes/thorax/motion/wall_inset.h>

#include <pleura/nodes/deformable/mesh/surface_query.h>

#include <algorithm>

namespace pleura {
namespace {

constexpr double kNear = 0.008;  // [m] bone farther from the wall, at rest or moved, does not bear on it
constexpr int kSpreads = 3;      // rounds over the grid's neighbours

std::vector<Eigen::Vector3f> gridPoints(std::span<const Eigen::Vector4f> grid) {
  std::vector<Eigen::Vector3f> points;
  points.reserve(grid.size());
  for (const Eigen::Vector4f& p : grid) points.push_back(p.head<3>());
  return points;
}

/// How far a point lies on the inner side of the wall [m], negative outside; none where it is not near.
struct Depth {
  double depth = 0.0;
  int triangle = -1;
};

Depth depthInside(const SurfaceQuery& surface, const Eigen::Vector3f& point) {
  const Eigen::Vector3d p = point.cast<double>();
  const auto foot = surface.closestPointWithin(p, kNear);
  if (!foot) return {};
  const bool inside = (p - foot->point).dot(surface.pseudonormal(*foot)) > 0.0;
  return {inside ? foot->distance : -foot->distance, foot->triangle};
}

void raise(float& value, double to) { value = std::max(value, static_cast<float>(to)); }

/// Largest of a node and its neighbours' less a fifth a round, so that the inset fades out.
void spread(const PleuralWall& wall, std::vector<float>& inset) {
  const std::vector<float> before = inset;
  for (int c = 0; c < PleuralWall::kColumns; ++c) {
    for (int r = 0; r < PleuralWall::kRows; ++r) {
      float& here = inset[PleuralWall::index(c, r)];
      const auto from = [&](int column, int row) {
        if (wall.open(column) || row < 0 || row >= PleuralWall::kRows) return;
        raise(here, 0.8 * before[PleuralWall::index(column, row)]);
      };
      from(PleuralWall::next(c), r);
      from(PleuralWall::previous(c), r);
      from(c, r + 1);
      from(c, r - 1);
    }
  }
}

}  // namespace

void setInset(PleuralWall& wall, std::span<const WallBody> bodies,
              std::span<const BodyDisplacement> displacements) {
  wall.inset.assign(wall.rest.size(), 0.0f);
  std::vector<Eigen::Vector4f> moved = wall.rest;
  moveWall(wall, displacements, 1.0, moved);
  const std::vector<Eigen::Vector3i> triangles = wallTriangles(wall);
  const SurfaceQuery before(gridPoints(wall.rest), triangles);
  const SurfaceQuery after(gridPoints(moved), triangles);
  for (const WallBody& body : bodies) {
    for (std::size_t i = 0; i < body.mesh->points.size(); ++i) {
      const Eigen::Vector4f rest = body.mesh->points[i].homogeneous();
      const Depth atRest = depthInside(before, rest.head<3>());
      const Depth now = depthInside(after, carry(rest, body.weights[i], displacements).head<3>());
      if (now.triangle < 0) continue;
      const double out = now.depth - std::max(atRest.depth, 0.0);
      if (out <= 0.0) continue;
      for (const int node : triangles[static_cast<std::size_t>(now.triangle)]) {
        raise(wall.inset[static_cast<std::size_t>(node)], out);
      }
    }
  }
  for (int round = 0; round < kSpreads; ++round) spread(wall, wall.inset);
}

}  // namespace pleura
