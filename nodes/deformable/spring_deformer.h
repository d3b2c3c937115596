#pragma once

#include <optional>
#include <vector>

#include <pleura/nodes/deformable/deformer_node.h>
#include <pleura/nodes/deformable/springs/spring_solver.h>

namespace pleura {

/// Springs along the edges of the shape, around nothing, a gas, a pressure or a held volume (springs/).
/// Driven points are exact; the others go where all forces balance.
class SpringDeformer : public DeformerNode {
 public:
  SFFloat stiffness;
  SFString interior;
  SFFloat pressure;
  SFFloat restPressure;
  SFFloat ambientPressure;

  SFInt32 iterations;
  SFFloat residual;
  SFBool converged;
  SFFloat interiorPressure;

  void setRest(const TriangleMesh& rest, std::span<const int> rigidPoints) override;
  void prepare(std::span<const int> driven) override;
  void solve(std::span<const int> driven, std::span<const Vec3f> targets,
             std::span<Vec3f> positions) override;
  void report() override;
  std::vector<Field*> inputs() override;

  static void declare(NodeType& type);

 private:
  void makeModel();
  /// Grows when the model has to be made anew: a pressure that is given is no part of it.
  std::uint64_t modelStamp() const;

  TriangleMesh rest_;
  std::optional<SpringModel> model_;
  std::optional<SpringWorkspace> workspace_;
  std::uint64_t modelStamp_ = 0;
  SpringReport report_;
  std::vector<Eigen::Vector3d> targets_, positions_;
};

}  // namespace pleura
