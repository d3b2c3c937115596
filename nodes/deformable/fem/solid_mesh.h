#pragma once

#include <vector>

#include <Eigen/Core>

namespace pleura {

/// A body of finite elements of one kind, at rest.
struct SolidMesh {
  std::vector<Eigen::Vector3d> nodes;  ///< [m]
  /// Node numbers, `nodesPerElement` an element. A tetrahedron's are right-handed: (1 - 0) x (2 - 0) points
  /// to 3. A hexahedron's are those of its corners in the order of bits: x is bit 0, y bit 1, z bit 2.
  std::vector<int> elements;
  int nodesPerElement = 4;  ///< 4: linear tetrahedra, 8: trilinear hexahedra
  std::vector<double>
      fill;  ///< part of each element inside the body, (0, 1]: scales stiffness and mass; empty: all 1

  int elementCount() const { return static_cast<int>(elements.size()) / nodesPerElement; }
};

/// What a body is made of.
struct SolidMaterial {
  double density = 1000;        ///< [kg/m^3], > 0
  double youngsModulus = 1e4;   ///< E [Pa], > 0
  double poissonRatio = 0.4;    ///< nu, [0, 0.5)
  double massDamping = 0;       ///< alpha [1/s] of D = alpha M + beta K, >= 0
  double stiffnessDamping = 0;  ///< beta [s], >= 0
};

}  // namespace pleura
