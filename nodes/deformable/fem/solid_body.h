#pragma once

#include <vector>

#include <pleura/nodes/deformable/fem/block_cholesky.h>
#include <pleura/nodes/deformable/fem/block_matrix.h>
#include <pleura/nodes/deformable/fem/element.h>
#include <pleura/nodes/deformable/fem/solid_solver.h>

namespace pleura {

/// Coordinates and forces beyond this are refused [m, N].
inline constexpr double kFarthestNode = 1e9;

/// What the solvers of a body share: its elements, masses, constraints and the pattern of its matrices.
struct SolidBody {
  SolidElements elements;
  Lame lame;
  double massDamping;        ///< alpha [1/s]
  double stiffnessDamping;   ///< beta [s]
  NodeVectors rest;          ///< [m]
  std::vector<double> mass;  ///< lumped: density times the integral of N_a, [node] [kg]
  SolidConstraints constraints;
  NodeVectors restTargets;    ///< W X [m]
  std::vector<int> unknowns;  ///< nodes that are not fixed and belong to an element
  std::vector<bool> isUnknown;

  BlockPattern pattern;
  std::vector<int> elementSlots;  ///< [element][a][b >= a] of the pattern
  std::vector<int> softSlots;     ///< [row][a][b >= a] of the pattern

  /// A block between an unknown and a fixed node.
  struct Coupling {
    int slot;  ///< ~slot: the transpose
    int unknown;
    int fixed;
  };
  std::vector<Coupling> couplings;
};

/// Throws std::invalid_argument as makeSolidElements and lameOf do, and on fixed nodes that are out of range
/// or named twice, and soft points whose rows do not fit or name a node twice, whose weights are not finite
/// or whose stiffness is negative.
SolidBody makeSolidBody(const SolidMesh& mesh, const SolidMaterial& material,
                        const SolidConstraints& constraints);

/// Whether sizes fit and all is finite and within 1e9, without a floating-point exception.
bool isUsable(const SolidBody& body, const SolidState& state);
bool isUsable(const SolidBody& body, const SolidLoad& load);
bool isUsableStep(double h);  ///< 1e-9 to 1e9 s, or infinite

/// A += (1/h^2 + alpha/h) M, `rate` 1/h.
void addInertia(const SolidBody& body, double rate, BlockValues& A);

/// values += k W^T W.
void addSoftStiffness(const SolidBody& body, BlockValues& values);

/// forces += k W^T (t - W x), t the targets.
void addSoftForces(const SolidBody& body, const SolidLoad& load, const NodeVectors& x, NodeVectors& forces);

/// k/2 |t - W x|^2 [J].
double softEnergy(const SolidBody& body, const SolidLoad& load, const NodeVectors& x);

/// b_i -= sum of A_ij d_j over fixed nodes j, for unknowns i.
void subtractFixed(const SolidBody& body, const BlockValues& A, const NodeVectors& d, NodeVectors& b);

/// Sets d to where the load wants fixed nodes, less where they are, and to 0 at the others.
void prescribe(const SolidBody& body, const SolidLoad& load, const NodeVectors& position, NodeVectors& d);

/// Norm over the unknowns.
double freeNorm(const SolidBody& body, const NodeVectors& x);

}  // namespace pleura
