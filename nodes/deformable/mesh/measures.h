#pragma once

#include <span>

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace pleura {

/// Neither NaN nor infinity in it. Raises no floating-point exception.
bool isFinite(const Eigen::Vector3f& point);

/// Throws std::invalid_argument naming the first that isn't.
void requireFinite(std::span<const Eigen::Vector3f> points);

/// Volume [m^3] a closed surface encloses, negative when its triangles face inwards (divergence theorem).
/// An open surface is closed by a cone to its first triangle's first corner. Indices must be in range.
double signedVolume(std::span<const Eigen::Vector3f> points, std::span<const Eigen::Vector3i> triangles);
double signedVolume(std::span<const Eigen::Vector3d> points, std::span<const Eigen::Vector3i> triangles);

/// Area [m^2] of all triangles. Indices must be in range.
double surfaceArea(std::span<const Eigen::Vector3f> points, std::span<const Eigen::Vector3i> triangles);

/// Smallest box around the points [m]; empty for no points.
Eigen::AlignedBox3f boundingBox(std::span<const Eigen::Vector3f> points);

/// Unit normals of the points, each triangle weighted by its angle there (Thuermer & Wuethrich 1998);
/// zero where no triangle of any area meets. `normals` is as long as `points`. Nothing is allocated.
void vertexNormals(std::span<const Eigen::Vector3f> points, std::span<const Eigen::Vector3i> triangles,
                   std::span<Eigen::Vector3f> normals);

/// How often the surface winds around p: 1 inside and 0 outside a closed one, between them near the holes of
/// an open one (Jacobson et al. 2013, solid angles by van Oosterom & Strackee 1983). Linear in the triangles.
double windingNumber(std::span<const Eigen::Vector3f> points, std::span<const Eigen::Vector3i> triangles,
                     const Eigen::Vector3d& p);

/// Angle [rad] between two directions, in [0, pi]; 0 if one has no length.
inline double angleBetween(const Eigen::Vector3d& u, const Eigen::Vector3d& v) {
  return std::atan2(u.cross(v).norm(), u.dot(v));
}

}  // namespace pleura
