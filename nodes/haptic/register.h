#pragma once

#include <pleura/nodes/core/node_registry.h>

namespace pleura {

/// Registers the nodes of touch: one line a type. Throws DuplicateTypeError where one is registered already.
void registerHapticNodes(NodeRegistry& registry);

}  // namespace pleura
