#pragma once

#include <limits>
#include <optional>
#include <span>
#include <vector>

#include <Eigen/Core>

#include <pleura/nodes/deformable/mesh/bounding_volume_tree.h>
#include <pleura/nodes/deformable/mesh/topology.h>

namespace pleura {

/// A place on a surface: point = sum barycentric[k] * corner k of the triangle.
struct SurfacePoint {
  Eigen::Vector3d point;        // [m]
  Eigen::Vector3d barycentric;  // exactly 0 where the point lies on an edge or at a corner
  double distance = 0;          // [m], from the asked point; along a ray in lengths of its direction
  int triangle = -1;
};

/// Nearest point, inside or outside, and rays against a surface that may move. Exact (double arithmetic on
/// the float points); built once, then refitted. Const members may be called from several threads at once.
/// Points that aren't finite throw std::invalid_argument and leave the last good surface in place.
class SurfaceQuery {
 public:
  /// Copies both. Throws std::invalid_argument also on no triangles and indices out of range. O(n log n).
  SurfaceQuery(std::span<const Eigen::Vector3f> points, std::span<const Eigen::Vector3i> triangles);

  /// The same surface with its points moved; as many points as before. Linear; nothing is allocated.
  void refit(std::span<const Eigen::Vector3f> points);

  /// Where the surface is nearest to p.
  SurfacePoint closestPoint(const Eigen::Vector3d& p) const;

  /// The same when it is nearer than maxDistance [m], and cheaper, since what is farther isn't looked at.
  std::optional<SurfacePoint> closestPointWithin(const Eigen::Vector3d& p, double maxDistance) const;

  /// Outward pseudonormal (not of unit length) at a place on the surface: on an edge the sum of its faces'
  /// unit normals, at a corner weighted by their angles there (Baerentzen & Aanaes 2005).
  Eigen::Vector3d pseudonormal(const SurfacePoint& at) const;

  /// Distance [m], negative inside. The sign is right for a closed surface with welded points that faces
  /// outwards; for an open one it tells the side of the nearest place.
  double signedDistance(const Eigen::Vector3d& p) const;

  /// Inside, with the same conditions; points on the surface count as outside.
  bool isInside(const Eigen::Vector3d& p) const { return signedDistance(p) < 0; }

  /// First place where origin + t * direction, 0 <= t <= maxT, meets the surface from either side; `distance`
  /// is t. Watertight along shared edges (Woop, Benthin & Wald 2013). Throws std::invalid_argument on
  /// direction 0.
  std::optional<SurfacePoint> intersectRay(const Eigen::Vector3d& origin, const Eigen::Vector3d& direction,
                                           double maxT = std::numeric_limits<double>::infinity()) const;

  /// Every place the ray meets, nearest first; an edge or corner it runs through counts once a triangle.
  std::vector<SurfacePoint> rayHits(const Eigen::Vector3d& origin, const Eigen::Vector3d& direction) const;

  std::span<const Eigen::Vector3f> points() const { return points_; }
  std::span<const Eigen::Vector3i> triangles() const { return triangles_; }

 private:
  Eigen::Matrix3d corners(int triangle) const;
  Eigen::Vector3d unitNormal(int triangle) const;
  double angleAt(int triangle, int point) const;

  std::vector<Eigen::Vector3f> points_;
  std::vector<Eigen::Vector3i> triangles_;
  Adjacency incident_;
  BoundingVolumeTree tree_;
};

}  // namespace pleura
