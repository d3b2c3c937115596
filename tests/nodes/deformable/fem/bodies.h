#pragma once

#include <numbers>
#include <random>
#include <string>
#include <vector>

#include "../mesh/shapes.h"
#include <Eigen/Geometry>

#include <pleura/nodes/deformable/mesh/measures.h>

namespace pleura::bodies {

/// The mesh with every point p moved to scale R p + offset.
inline TriangleMesh placed(TriangleMesh mesh, const Eigen::Vector3d& offset,
                           const Eigen::Matrix3d& linear = Eigen::Matrix3d::Identity()) {
  for (Eigen::Vector3f& point : mesh.points) point = (linear * point.cast<double>() + offset).cast<float>();
  return mesh;
}

inline TriangleMesh together(TriangleMesh first, const TriangleMesh& second) {
  const int shift = static_cast<int>(first.points.size());
  first.points.insert(first.points.end(), second.points.begin(), second.points.end());
  for (const Eigen::Vector3i& triangle : second.triangles)
    first.triangles.push_back(triangle.array() + shift);
  return first;
}

/// Without the triangles that have a corner beyond the plane.
inline TriangleMesh cut(TriangleMesh mesh, const Eigen::Vector3f& normal, float offset) {
  std::erase_if(mesh.triangles, [&](const Eigen::Vector3i& triangle) {
    for (const int corner : triangle)
      if (mesh.points[corner].dot(normal) > offset) return true;
    return false;
  });
  return mesh;
}

inline Eigen::Matrix3d tilted() {
  return Eigen::AngleAxisd(0.7, Eigen::Vector3d(1, 2, 3).normalized()).toRotationMatrix();
}

inline double volumeOf(const TriangleMesh& mesh) { return signedVolume(mesh.points, mesh.triangles); }

struct Named {
  std::string name;
  TriangleMesh mesh;
};

/// Sound closed surfaces, some in general position.
inline std::vector<Named> sound() {
  const Eigen::Matrix3d ellipsoid = tilted() * Eigen::Vector3d(1, 0.6, 0.3).asDiagonal();
  return {{"sphere", shapes::sphere(48)},
          {"ellipsoid", placed(shapes::sphere(48), Eigen::Vector3d::Zero(), ellipsoid)},
          {"torus", placed(shapes::torus(60, 30), Eigen::Vector3d::Zero(), tilted())},
          {"cube", shapes::cube()},
          {"tilted cube", placed(shapes::cube(), Eigen::Vector3d::Zero(), tilted())}};
}

}  // namespace pleura::bodies
