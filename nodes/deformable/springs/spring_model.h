#pragma once

#include <span>
#include <vector>

#include <Eigen/Core>

#include <pleura/nodes/deformable/springs/spring_interior.h>

namespace pleura {

/// What the springs and points of a surface are made of.
struct SpringMaterial {
  std::vector<double> stiffness{
      100};  // [N/m], above 0: one an edge as mesh/topology.h lists them, or one for all
  std::vector<double> mass{1e-3};  // [kg], 0 or more: one a point, or one for all
  double relaxationTime = 0;       // of each spring [s], 0 or more: its damper over its stiffness
};

/// A surface ready to be solved for.
struct SpringModel {
  std::vector<Eigen::Vector3d> rest;       // [m]
  std::vector<int> begin;                  // pointCount() + 1: springs begin[a] .. begin[a + 1] - 1 join a to
  std::vector<int> end;                    // end[spring], a point above a
  std::vector<double> stiffness;           // of each spring [N/m]
  std::vector<double> length;              // as meshed [m]
  std::vector<double> mass;                // of each point [kg]
  double relaxationTime = 0;               // [s]
  std::vector<Eigen::Vector3i> triangles;  // of the surface around the interior; none around an empty one
  SpringInterior interior;
  double extent = 0;       // longest side of the box around the points at rest [m]
  double restVolume = 0;   // [m^3]
  double holdModulus = 0;  // of a VolumeInterior [Pa], see VolumeHold
  double forceUnit = 0;  // [N] root of the sum over points of (sum of k l)^2, what residuals are measured in

  int pointCount() const { return static_cast<int>(rest.size()); }
};

/// A point and its springs take about 650 bytes, and a solve minutes at these numbers.
inline constexpr std::size_t kMostSpringPoints = 1'000'000, kMostSpringTriangles = 4'000'000;

/// Springs along the edges of a surface, as long as meshed, around an interior. Points without triangles,
/// triangles without area and repeated ones are allowed. Throws std::invalid_argument on no triangles, over
/// kMostSpringPoints or kMostSpringTriangles, an index out of range, a point not finite or beyond
/// kSpringFarthest, numbers of stiffnesses or masses that don't fit, values out of the ranges above; and,
/// unless the interior is empty, on a surface that is open, not consistently oriented, or has no positive
/// volume.
SpringModel makeSpringModel(std::span<const Eigen::Vector3f> rest, std::span<const Eigen::Vector3i> triangles,
                            const SpringMaterial& material, const SpringInterior& interior);

/// Coordinates beyond this [m] are refused, and stiffnesses [N/m] and masses [kg] as large: products of a few
/// of them stay finite.
inline constexpr double kSpringFarthest = 1e12;

}  // namespace pleura
