#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include <Eigen/Core>

#include <pleura/nodes/deformable/fem/solid_mesh.h>

namespace pleura {

/// Throws std::invalid_argument: what of a body can't be used.
[[noreturn]] void refuseSolid(const std::string& what);

inline constexpr int kMostElementNodes = 8, kMostElementPoints = 8;
inline constexpr int kMostElements = 1'000'000;

/// The elements of a body at rest, isoparametric, as flat arrays: linear tetrahedra with one quadrature
/// point, trilinear hexahedra with 2 x 2 x 2. Dilatation is to be taken from the mean gradient (B-bar, Hughes
/// 1980), with which hexahedra do not lock as nu approaches 0.5; of a tetrahedron it is the gradient itself.
struct SolidElements {
  int nodesPerElement = 4;
  int pointsPerElement = 1;
  std::vector<int> node;                      ///< [element][a]
  std::vector<Eigen::Vector3d> gradient;      ///< [element][point][a] dN_a/dX [1/m]
  std::vector<Eigen::Vector3d> meanGradient;  ///< [element][a] its mean over the volume [1/m]
  std::vector<double> weight;                 ///< [element][point] volume times fill [m^3]
  std::vector<double> nodeVolume;             ///< [node of the mesh] integral of N_a times fill [m^3]
  int degenerateCount = 0;  ///< elements of the mesh left out: flat, inside out, or nearly so

  int count() const { return static_cast<int>(node.size()) / nodesPerElement; }
  const int* nodesOf(int element) const { return node.data() + std::ptrdiff_t{element} * nodesPerElement; }
  /// Of quadrature point element * pointsPerElement + q.
  const Eigen::Vector3d* gradientsAt(int point) const {
    return gradient.data() + std::ptrdiff_t{point} * nodesPerElement;
  }
};

/// Throws std::invalid_argument on a mesh that is empty, has over kMostElements or none that is not
/// degenerate, indices out of range, other than 4 or 8 nodes an element, a node that is not finite or farther
/// than 1e6 m, or a fill outside (0, 1]. An element is degenerate when its volume, at any quadrature point,
/// is below 1e-9 of the cube of its longest edge or diagonal.
SolidElements makeSolidElements(const SolidMesh& mesh);

/// Lame's constants [Pa].
struct Lame {
  double lambda;
  double mu;
};

/// Throws std::invalid_argument unless rho, E > 0, 0 <= nu < 0.5, alpha, beta >= 0 and all are at most 1e15.
Lame lameOf(const SolidMaterial& material);

/// The part K_ab of an element's stiffness [N/m] that belongs to one of its quadrature points,
///   w [(lambda + 2/3 mu) m_a m_b^T + mu (g_a.g_b I + g_b g_a^T - 2/3 g_a g_b^T)],
/// from shape gradients g and their means m.
Eigen::Matrix3d stiffnessBlock(const Lame& lame, double w, const Eigen::Vector3d& ga,
                               const Eigen::Vector3d& gb, const Eigen::Vector3d& ma,
                               const Eigen::Vector3d& mb);

}  // namespace pleura
