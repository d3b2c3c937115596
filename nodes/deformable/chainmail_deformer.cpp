#include <algorithm>
#include <vector>

#include <pleura/nodes/deformable/chainmail_deformer.h>

namespace pleura {

void ChainmailDeformer::declare(NodeType& type) {
  DeformerNode::declare(type);
  type.named("ChainmailDeformer", "Pleura").means("moves an organ's points by Generalised ChainMail");
  using enum Access;
  type.field<&ChainmailDeformer::compressionFactor>("compressionFactor", inputOutput, 0.33333f)
      .within(0, 1)
      .means("how short a link may become, of its rest offset");
  type.field<&ChainmailDeformer::stretchFactor>("stretchFactor", inputOutput, 1.25f)
      .within(1, 1000)
      .means("how long a link may become, of its rest offset");
  type.field<&ChainmailDeformer::shearFactor>("shearFactor", inputOutput, 0.25f)
      .within(0, 1000)
      .means("how far a link may go aside, of its length across");
  type.field<&ChainmailDeformer::smoothing>("smoothing", inputOutput, 0)
      .within(0, 100)
      .means("sweeps that even out the displacement, within the links' limits");
  type.field<&ChainmailDeformer::violatedLinks>("violatedLinks", outputOnly, 0)
      .means("links that contradicting driven points left beyond their limits");
}

void ChainmailDeformer::setRest(const TriangleMesh& rest, std::span<const int> rigidPoints) {
  const ChainmailMaterial soft{compressionFactor.getValue(), stretchFactor.getValue(),
                               shearFactor.getValue()};
  std::vector<ChainmailMaterial> material(rest.points.size(), soft);
  for (const int point : rigidPoints)
    if (point >= 0 && point < static_cast<int>(material.size()))
      material[static_cast<std::size_t>(point)] = kRigid;
  model_ = makeChainmailModel(rest.points, linkTriangles(rest.points, rest.triangles), material);
  workspace_.emplace(model_->topology.pointCount());
}

void ChainmailDeformer::prepare(std::span<const int> /*driven*/) {
  options_.smoothingSweeps = std::max(0, smoothing.getValue());
}

void ChainmailDeformer::solve(std::span<const int> driven, std::span<const Vec3f> targets,
                              std::span<Vec3f> positions) {
  report_ = solveChainmail(*model_, *workspace_, driven, targets, options_, positions);
}

void ChainmailDeformer::report() { violatedLinks.setValue(report_.violatedLinks, id); }

}  // namespace pleura
