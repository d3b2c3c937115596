#pragma once

#include <optional>

#include <pleura/nodes/deformable/chainmail/chainmail_solver.h>
#include <pleura/nodes/deformable/deformer_node.h>

namespace pleura {

/// Generalised ChainMail (Li and Brodlie 2003) without the faults of its published code, see
/// chainmail/chainmail_solver.h.
class ChainmailDeformer : public DeformerNode {
 public:
  SFFloat compressionFactor;
  SFFloat stretchFactor;
  SFFloat shearFactor;
  SFInt32 smoothing;

  SFInt32 violatedLinks;

  void setRest(const TriangleMesh& rest, std::span<const int> rigidPoints) override;
  void prepare(std::span<const int> driven) override;
  void solve(std::span<const int> driven, std::span<const Vec3f> targets,
             std::span<Vec3f> positions) override;
  void report() override;

  static void declare(NodeType& type);

 private:
  std::optional<ChainmailModel> model_;
  std::optional<ChainmailWorkspace> workspace_;
  ChainmailOptions options_;
  ChainmailReport report_;
};

}  // namespace pleura
