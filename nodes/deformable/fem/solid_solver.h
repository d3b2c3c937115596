#pragma once

#include <span>
#include <vector>

#include <Eigen/Core>

#include <pleura/nodes/deformable/fem/block_matrix.h>
#include <pleura/nodes/deformable/fem/solid_mesh.h>

namespace pleura {

/// Points of a body held by springs, as the sparse rows of W: point r is at the sum of weight[k] times the
/// position of node[k], k from begin[r] to begin[r + 1] - 1. Towards its target t_r it is pulled by
/// stiffness (t_r - (W x)r_) [N].
struct SoftPoints {
  std::vector<int> begin{0};
  std::vector<int> node;
  std::vector<double> weight;
  double stiffness = 0;  ///< k [N/m], >= 0

  int count() const { return static_cast<int>(begin.size()) - 1; }
};

struct SolidConstraints {
  std::vector<int> fixed;  ///< nodes whose positions are prescribed
  SoftPoints soft;
};

/// Where a body is, by nodes.
struct SolidState {
  NodeVectors position;  ///< [m]
  NodeVectors velocity;  ///< [m/s]
};

/// What acts on a body during a step. Each part may be left empty.
struct SolidLoad {
  std::span<const Eigen::Vector3d> forces{};  ///< one a node [N]; empty: none
  std::span<const Eigen::Vector3d>
      prescribed{};  ///< where fixed nodes are after the step [m]; empty: as they are
  std::span<const Eigen::Vector3d> targets{};  ///< of the soft points [m]; empty: as at rest
};

enum class SolidOutcome {
  converged,
  stopped,   ///< out of iterations: the state has moved on, to a lower energy, and is not the answer yet
  badInput,  ///< sizes that do not fit, something not finite or beyond 1e9, a step out of range: the state is
             ///< kept
  singular,  ///< the body can move without strain (too few fixed nodes for a static answer): the state is
             ///< kept
  failed,    ///< no descent, or nothing finite: the state is kept
};

struct SolidReport {
  SolidOutcome outcome = SolidOutcome::converged;
  int iterations = 0;   ///< linear systems solved or, when solved iteratively, products with their matrix
  double residual = 0;  ///< forces out of balance over those at the step's start, reactions among them
  bool converged() const { return outcome == SolidOutcome::converged; }
};

/// A body of finite elements that moves under loads, lumped masses, damping D = alpha M + beta K and backward
/// Euler; in static answers neither inertia nor damping. Nodes that belong to no element stay where they are
/// put. A step throws nothing.
class SolidSolver {
 public:
  virtual ~SolidSolver() = default;

  /// Moves on by h [s], 1e-9 to 1e9; h infinite: to the static answer. The first step of another h costs
  /// more.
  virtual SolidReport step(double h, const SolidLoad& load) = 0;
  virtual const SolidState& state() const = 0;
  /// False, and no change, when sizes do not fit or something is not finite or beyond 1e9.
  virtual bool setState(const SolidState& state) = 0;
  /// Elastic energy of the body in this state [J].
  virtual double energy() const = 0;
  /// Elements of the mesh left out because they are degenerate at rest.
  virtual int degenerateCount() const = 0;
};

}  // namespace pleura
