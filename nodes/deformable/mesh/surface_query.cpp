#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include <Eigen/Geometry>

#include <pleura/nodes/deformable/mesh/measures.h>
#include <pleura/nodes/deformable/mesh/surface_query.h>
#include <pleura/nodes/deformable/mesh/triangle_geometry.h>

namespace pleura {

using Eigen::Vector3d;
using Eigen::Vector3f;
using Eigen::Vector3i;
using FourCorners = BoundingVolumeTree::FourCorners;
using FourBounds = BoundingVolumeTree::FourBounds;

namespace {

constexpr double largestFloat = std::numeric_limits<float>::max();
constexpr double smallestFloat = std::numeric_limits<float>::min();

/// Beyond a float's range there is no surface, and squares would overflow.
void requireFloatRange(const Vector3d& v, const char* name) {
  const auto inRange = [](double x) { return std::isfinite(x) && std::abs(x) <= largestFloat; };
  if (!std::all_of(v.begin(), v.end(), inRange))
    throw std::invalid_argument(std::string(name) + ": not finite, or beyond a float's range");
}

void requireNotNegative(double value, const char* name) {
  if (std::isnan(value) || value < 0)
    throw std::invalid_argument(std::string(name) + ": must not be negative");
}

Ray checkedRay(const Vector3d& origin, const Vector3d& direction) {
  requireFloatRange(origin, "origin");
  requireFloatRange(direction, "direction");
  if (direction.cwiseAbs().maxCoeff() < smallestFloat)
    throw std::invalid_argument("direction: has no length");
  return {origin, direction};
}

std::span<const Vector3f> checked(std::span<const Vector3f> points) {
  requireFinite(points);
  return points;
}

std::span<const Vector3i> checked(std::size_t pointCount, std::span<const Vector3i> triangles) {
  if (triangles.empty()) throw std::invalid_argument("triangles: a surface needs at least one");
  requireIndicesInRange(pointCount, triangles);
  return triangles;
}

bool uses(const Vector3i& triangle, int point) { return (triangle.array() == point).any(); }

/// Distance squared from p to each of four boxes, 0 inside.
FourBounds squaredDistances(const Vector3d& p, const FourCorners& low, const FourCorners& high) {
  FourBounds sum = FourBounds::Zero();
  for (int k = 0; k < 3; ++k) {
    const FourBounds outside = (low.col(k) - p[k]).max(p[k] - high.col(k)).max(0.0);
    sum += outside * outside;
  }
  return sum;
}

/// Where a line enters each of four boxes, in lengths of its direction and not before 0; infinity where it
/// misses.
class BoxEntry {
 public:
  explicit BoxEntry(const Ray& ray) : origin_(ray.origin()) {
    const double longest = ray.direction().cwiseAbs().maxCoeff();
    for (int k = 0; k < 3; ++k) {
      across_[k] = std::abs(ray.direction()[k]) <= negligible * longest;
      inverse_[k] = across_[k] ? 0 : 1 / ray.direction()[k];
    }
  }

  FourBounds operator()(const FourCorners& low, const FourCorners& high) const {
    constexpr double never = std::numeric_limits<double>::infinity();
    FourBounds entry = FourBounds::Zero();
    FourBounds exit = FourBounds::Constant(never);
    for (int k = 0; k < 3; ++k) {
      const FourBounds atLow = low.col(k) - origin_[k], atHigh = high.col(k) - origin_[k];
      if (across_[k]) {
        exit = (atLow <= 0 && atHigh >= 0).select(exit, -1.0);
        continue;
      }
      const FourBounds t0 = atLow * inverse_[k], t1 = atHigh * inverse_[k];
      entry = entry.max(t0.min(t1) * (1 - rounding));
      exit = exit.min(t0.max(t1) * (1 + rounding));
    }
    return (entry <= exit).select(entry, never);
  }

 private:
  static constexpr double negligible = 1e-60;  // of the direction: no float box is that thin and that far
  static constexpr double rounding = 8 * std::numeric_limits<double>::epsilon();

  Vector3d origin_;
  Vector3d inverse_;
  Eigen::Array<bool, 3, 1> across_;
};

}  // namespace

SurfaceQuery::SurfaceQuery(std::span<const Vector3f> points, std::span<const Vector3i> triangles)
    : points_(checked(points).begin(), points.end()),
      triangles_(checked(points.size(), triangles).begin(), triangles.end()),
      incident_(incidentTriangles(points_.size(), triangles_)),
      tree_(points_, triangles_) {}

void SurfaceQuery::refit(std::span<const Vector3f> points) {
  if (points.size() != points_.size())
    throw std::invalid_argument("points: " + std::to_string(points.size()) + " for a surface of " +
                                std::to_string(points_.size()));
  requireFinite(points);
  std::copy(points.begin(), points.end(), points_.begin());
  tree_.refit(points_, triangles_);
}

SurfacePoint SurfaceQuery::closestPoint(const Vector3d& p) const {
  return *closestPointWithin(p, std::numeric_limits<double>::infinity());
}

std::optional<SurfacePoint> SurfaceQuery::closestPointWithin(const Vector3d& p, double maxDistance) const {
  requireFloatRange(p, "p");
  requireNotNegative(maxDistance, "maxDistance");
  const double reach = std::min(maxDistance, 8 * largestFloat);
  TrianglePoint nearest{Vector3d::Zero(), Vector3d::Zero(), reach * reach};
  int nearestTriangle = -1;
  tree_.visitNearestFirst(
      nearest.squaredDistance,
      [&p](const FourCorners& low, const FourCorners& high) { return squaredDistances(p, low, high); },
      [&](int triangle) {
        const TrianglePoint candidate = closestPointOnTriangle(corners(triangle), p);
        if (candidate.squaredDistance < nearest.squaredDistance) {
          nearest = candidate;
          nearestTriangle = triangle;
        }
        return nearest.squaredDistance;
      });
  if (nearestTriangle < 0) return std::nullopt;
  return SurfacePoint{nearest.point, nearest.weights, std::sqrt(nearest.squaredDistance), nearestTriangle};
}

Vector3d SurfaceQuery::pseudonormal(const SurfacePoint& at) const {
  const Vector3i& triangle = triangles_[at.triangle];
  int first = 0;
  at.barycentric.maxCoeff(&first);
  const int next = (first + 1) % 3, last = (first + 2) % 3;
  const bool onNext = at.barycentric[next] > 0, onLast = at.barycentric[last] > 0;
  if (onNext && onLast) return unitNormal(at.triangle);

  const int corner = triangle[first];
  const bool onEdge = onNext || onLast;
  const int other = onNext ? triangle[next] : triangle[last];
  Vector3d sum = Vector3d::Zero();
  for (const int t : incident_[corner]) {
    if (onEdge && !uses(triangles_[t], other)) continue;
    sum += (onEdge ? 1.0 : angleAt(t, corner)) * unitNormal(t);
  }
  return sum;
}

double SurfaceQuery::signedDistance(const Vector3d& p) const {
  const SurfacePoint nearest = closestPoint(p);
  return (p - nearest.point).dot(pseudonormal(nearest)) < 0 ? -nearest.distance : nearest.distance;
}

std::optional<SurfacePoint> SurfaceQuery::intersectRay(const Vector3d& origin, const Vector3d& direction,
                                                       double maxT) const {
  requireFloatRange(origin, "origin");
  requireFloatRange(direction, "direction");
  if (direction.cwiseAbs().maxCoeff() < smallestFloat)
    throw std::invalid_argument("direction: has no length");
  requireNotNegative(maxT, "maxT");
  const Ray ray(origin, direction);
  const double reach = std::min(maxT, std::numeric_limits<double>::max());
  std::optional<SurfacePoint> first;
  tree_.visitNearestFirst(reach, BoxEntry(ray), [&](int triangle) {
    const double limit = first ? first->distance : reach;
    const std::optional<Ray::Hit> hit = ray.meet(corners(triangle));
    if (!hit || hit->t < 0 || hit->t > limit || (first && hit->t == limit)) return limit;
    first = SurfacePoint{corners(triangle) * hit->weights, hit->weights, hit->t, triangle};
    return hit->t;
  });
  return first;
}

std::vector<SurfacePoint> SurfaceQuery::rayHits(const Vector3d& origin, const Vector3d& direction) const {
  const Ray ray = checkedRay(origin, direction);
  constexpr double reach = std::numeric_limits<double>::max();
  std::vector<SurfacePoint> hits;
  tree_.visitNearestFirst(reach, BoxEntry(ray), [&](int triangle) {
    const std::optional<Ray::Hit> hit = ray.meet(corners(triangle));
    if (hit && hit->t >= 0)
      hits.push_back({corners(triangle) * hit->weights, hit->weights, hit->t, triangle});
    return reach;
  });
  std::ranges::sort(hits, {}, [](const SurfacePoint& hit) { return std::pair(hit.distance, hit.triangle); });
  return hits;
}

Eigen::Matrix3d SurfaceQuery::corners(int triangle) const {
  const Vector3i& t = triangles_[triangle];
  Eigen::Matrix3d result;
  result << points_[t[0]].cast<double>(), points_[t[1]].cast<double>(), points_[t[2]].cast<double>();
  return result;
}

Vector3d SurfaceQuery::unitNormal(int triangle) const {
  const Eigen::Matrix3d c = corners(triangle);
  return Vector3d(c.col(1) - c.col(0)).cross(Vector3d(c.col(2) - c.col(0))).normalized();
}

double SurfaceQuery::angleAt(int triangle, int point) const {
  const Eigen::Matrix3d c = corners(triangle);
  int k = 0;
  while (triangles_[triangle][k] != point) ++k;
  return angleBetween(c.col((k + 1) % 3) - c.col(k), c.col((k + 2) % 3) - c.col(k));
}

}  // namespace pleura
