#pragma once

#include <algorithm>
#include <array>
#include <functional>
#include <limits>
#include <random>
#include <utility>
#include <vector>

#include <Eigen/Geometry>

#include <pleura/nodes/deformable/fem/solid_solver.h>
#include <pleura/nodes/deformable/fem/tetrahedra.h>

namespace pleura {

/// Cells n.x by n.y by n.z of a box from the origin; five tetrahedra a cell, mirrored from cell to cell so
/// that they fit, or one hexahedron.
inline SolidMesh box(const Eigen::Vector3i& n, const Eigen::Vector3d& size, int nodesPerElement) {
  SolidMesh mesh;
  mesh.nodesPerElement = nodesPerElement;
  const auto corner = [&](int x, int y, int z) { return x + (n.x() + 1) * (y + (n.y() + 1) * z); };
  for (int z = 0; z <= n.z(); ++z)
    for (int y = 0; y <= n.y(); ++y)
      for (int x = 0; x <= n.x(); ++x)
        mesh.nodes.push_back(Eigen::Vector3d(x, y, z).cwiseQuotient(n.cast<double>()).cwiseProduct(size));
  for (int z = 0; z < n.z(); ++z)
    for (int y = 0; y < n.y(); ++y)
      for (int x = 0; x < n.x(); ++x) {
        std::array<int, 8> at;
        for (int bits = 0; bits < 8; ++bits)
          at[static_cast<std::size_t>(bits)] = corner(x + (bits & 1), y + ((bits >> 1) & 1), z + (bits >> 2));
        if (nodesPerElement == 8)
          mesh.elements.insert(mesh.elements.end(), at.begin(), at.end());
        else
          addTetrahedra(at, (x + y + z) % 2 == 0, mesh.elements);
      }
  return mesh;
}

inline SolidMesh cube(int n, int nodesPerElement) {
  return box(Eigen::Vector3i::Constant(n), Eigen::Vector3d::Ones(), nodesPerElement);
}

inline std::vector<int> nodesWhere(const SolidMesh& mesh,
                                   const std::function<bool(const Eigen::Vector3d&)>& chosen) {
  std::vector<int> nodes;
  for (std::size_t i = 0; i < mesh.nodes.size(); ++i)
    if (chosen(mesh.nodes[i])) nodes.push_back(static_cast<int>(i));
  return nodes;
}

/// The face x = 0.
inline std::vector<int> clampedFace(const SolidMesh& mesh) {
  return nodesWhere(mesh, [](const auto& x) { return x.x() <= 0; });
}

/// Moves the nodes inside of the unit cube about, by up to `by`.
inline void distort(SolidMesh& mesh, double by) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> uniform(-by, by);
  for (auto& x : mesh.nodes)
    if (x.minCoeff() > 0 && x.maxCoeff() < 1)
      x += Eigen::Vector3d(uniform(random), uniform(random), uniform(random));
}

/// Weights [N] of the nodes of a body under g [m/s^2].
inline NodeVectors weights(const std::vector<double>& mass, const Eigen::Vector3d& g) {
  NodeVectors forces;
  for (const double m : mass) forces.push_back(m * g);
  return forces;
}

inline constexpr double kStatic = std::numeric_limits<double>::infinity();

/// The cube of the closed form: 1 m, 1 kg.
inline SolidMaterial softCube() { return {.density = 1, .youngsModulus = 2e4, .poissonRatio = 0.4}; }

}  // namespace pleura
