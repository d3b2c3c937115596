#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>

#include <pleura/nodes/deformable/mesh/measures.h>

namespace pleura {

using Eigen::Vector3d;
using Eigen::Vector3f;
using Eigen::Vector3i;

namespace {

template <class Point>
double volumeWithin(std::span<const Point> points, std::span<const Vector3i> triangles) {
  if (triangles.empty()) return 0;
  // V = 1/6 sum a . (b x c), taken from a point of the surface so that nothing is lost far from the origin.
  const Vector3d origin = points[triangles[0][0]].template cast<double>();
  double sixVolumes = 0;
  for (const Vector3i& triangle : triangles) {
    const Vector3d a = points[triangle[0]].template cast<double>() - origin;
    const Vector3d b = points[triangle[1]].template cast<double>() - origin;
    const Vector3d c = points[triangle[2]].template cast<double>() - origin;
    sixVolumes += a.dot(b.cross(c));
  }
  return sixVolumes / 6;
}

}  // namespace

bool isFinite(const Vector3f& point) {
  // not allFinite(), which subtracts infinities and so raises the floating-point exception it should prevent
  return std::all_of(point.begin(), point.end(), [](float x) { return std::isfinite(x); });
}

void requireFinite(std::span<const Vector3f> points) {
  const auto bad = std::find_if_not(points.begin(), points.end(), isFinite);
  if (bad != points.end())
    throw std::invalid_argument("points: point " + std::to_string(bad - points.begin()) + " is not finite");
}

double signedVolume(std::span<const Vector3f> points, std::span<const Vector3i> triangles) {
  return volumeWithin(points, triangles);
}

double signedVolume(std::span<const Vector3d> points, std::span<const Vector3i> triangles) {
  return volumeWithin(points, triangles);
}

double surfaceArea(std::span<const Vector3f> points, std::span<const Vector3i> triangles) {
  double twoAreas = 0;
  for (const Vector3i& triangle : triangles) {
    const Vector3d a = points[triangle[0]].cast<double>();
    const Vector3d ab = points[triangle[1]].cast<double>() - a;
    const Vector3d ac = points[triangle[2]].cast<double>() - a;
    twoAreas += ab.cross(ac).norm();
  }
  return twoAreas / 2;
}

Eigen::AlignedBox3f boundingBox(std::span<const Vector3f> points) {
  Eigen::AlignedBox3f box;
  for (const Vector3f& point : points) box.extend(point);
  return box;
}

void vertexNormals(std::span<const Vector3f> points, std::span<const Vector3i> triangles,
                   std::span<Vector3f> normals) {
  if (normals.size() != points.size())
    throw std::invalid_argument("normals: " + std::to_string(normals.size()) + " for " +
                                std::to_string(points.size()) + " points");
  std::fill(normals.begin(), normals.end(), Vector3f::Zero());
  for (const Vector3i& triangle : triangles) {
    const Vector3d a = points[triangle[0]].cast<double>();
    const Vector3d b = points[triangle[1]].cast<double>();
    const Vector3d c = points[triangle[2]].cast<double>();
    const Vector3d n = (b - a).cross(c - a).normalized();
    normals[triangle[0]] += (angleBetween(b - a, c - a) * n).cast<float>();
    normals[triangle[1]] += (angleBetween(c - b, a - b) * n).cast<float>();
    normals[triangle[2]] += (angleBetween(a - c, b - c) * n).cast<float>();
  }
  for (Vector3f& normal : normals) normal.normalize();
}

double windingNumber(std::span<const Vector3f> points, std::span<const Vector3i> triangles,
                     const Vector3d& p) {
  double halfSolidAngles = 0;
  for (const Vector3i& triangle : triangles) {
    const Vector3d a = points[triangle[0]].cast<double>() - p;
    const Vector3d b = points[triangle[1]].cast<double>() - p;
    const Vector3d c = points[triangle[2]].cast<double>() - p;
    // tan(Omega / 2) = a . (b x c) / (|a||b||c| + (a . b)|c| + (b . c)|a| + (c . a)|b|)
    const double la = a.norm(), lb = b.norm(), lc = c.norm();
    halfSolidAngles +=
        std::atan2(a.dot(b.cross(c)), la * lb * lc + a.dot(b) * lc + b.dot(c) * la + c.dot(a) * lb);
  }
  return halfSolidAngles / (2 * std::numbers::pi);
}

}  // namespace pleura
