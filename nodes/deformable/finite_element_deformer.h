#pragma once

#include <memory>
#include <vector>

#include <pleura/nodes/deformable/deformer_node.h>
#include <pleura/nodes/deformable/fem/embedding.h>
#include <pleura/nodes/deformable/fem/solid_solver.h>

namespace pleura {

/// Finite elements in a lattice of cubes, or of cubes cut into tetrahedra, inside the shape: linear,
/// corotational or stable Neo-Hookean elasticity (fem/). Driven points are held by stiff springs, and then
/// put exactly where they are to be. Static answers have no memory; with quasiStatic FALSE the shape moves by
/// backward Euler, with inertia and damping, as the scene's time does.
class FiniteElementDeformer : public DeformerNode {
 public:
  SFString model;
  SFInt32 elements;
  SFString elementType;
  SFFloat density;
  SFFloat youngsModulus;
  SFFloat poissonRatio;
  SFFloat massDamping;
  SFFloat stiffnessDamping;
  SFBool quasiStatic;
  SFFloat pressure;
  SFFloat restPressure;

  SFInt32 elementCount;
  SFInt32 iterations;
  SFFloat residual;
  SFBool converged;

  void setRest(const TriangleMesh& rest, std::span<const int> rigidPoints) override;
  void prepare(std::span<const int> driven) override;
  void solve(std::span<const int> driven, std::span<const Vec3f> targets,
             std::span<Vec3f> positions) override;
  void report() override;
  std::vector<Field*> inputs() override;

  static void declare(NodeType& type);

 private:
  /// Fields that a solver is made for.
  std::vector<Field*> material();
  bool hasTetrahedra();
  /// Of the fields that the mesh is made for.
  std::uint64_t meshStamp();
  void makeMesh();
  void makeSolver(std::span<const int> driven);
  bool isAtRest(std::span<const Vec3f> targets) const;
  /// Moves the elements on to what was asked for.
  SolidReport move(std::span<const Vec3f> targets);

  TriangleMesh rest_;
  SolidMesh mesh_;
  double cellSize_ = 0;  // [m]
  Embedding embedding_;
  std::unique_ptr<SolidSolver> solver_;
  std::vector<int> driven_;  // that the solver was made for
  std::uint64_t meshStamp_ = 0, solverStamp_ = 0;
  SolidState atRest_;
  Time time_ = 0;        // of the state
  Time asked_ = 0;       // of the next solve
  double step_ = 0;      // of the next solve [s]; infinite: to the static answer; 0: none
  double pressure_ = 0;  // inside less outside, above that at rest [Pa]
  SolidReport report_;
  // Work space.
  std::vector<Eigen::Vector3d> targets_, points_;
  std::vector<Eigen::Vector3d> pull_;    // of a pressure of 1 Pa on the nodes, at rest [N]
  std::vector<Eigen::Vector3d> forces_;  // on the nodes [N]
};

}  // namespace pleura
