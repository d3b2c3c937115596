#include <pleura/nodes/core/plugin.h>
#include <pleura/nodes/lung/causal_chain_node.h>
#include <pleura/nodes/lung/planar_chest.h>
#include <pleura/nodes/lung/planar_lung.h>
#include <pleura/nodes/lung/pleural_space.h>

namespace pleura {

void registerLungNodes(NodeRegistry& registry) {
  registry.add<CausalChainNode>();
  registry.add<PlanarChest>();
  registry.add<PlanarLung>();
  registry.add<PleuralSpace>();
}

}  // namespace pleura

PLEURA_PLUGIN(pleura::registerLungNodes)
