#include <pleura/nodes/built_in_nodes.h>
#include <pleura/nodes/haptic/register.h>
#include <pleura/nodes/standard/register.h>

namespace pleura {

void registerBuiltInNodes(NodeRegistry& registry) {
  registerStandardNodes(registry);
  registerHapticNodes(registry);
}

}  // namespace pleura
