#include <pleura/nodes/chain/deformable_shape2.h>
#include <pleura/nodes/chain/rot_transform.h>
#include <pleura/nodes/core/plugin.h>
#include <pleura/nodes/deformable/chainmail_deformer.h>

namespace pleura {

/// The thesis' own library (Jacob 2008): its scenes load this one alone, so that a scene with "thorax" as
/// well is told that types are registered twice.
void registerChainNodes(NodeRegistry& registry) {
  registry.add<ChainmailDeformer>();
  registry.add<chain::DeformableShape2>();
  registry.add<chain::RotTransform>();
}

}  // namespace pleura

PLEURA_PLUGIN(pleura::registerChainNodes)
