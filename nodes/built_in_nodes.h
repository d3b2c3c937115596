#pragma once

#include <pleura/nodes/core/node_registry.h>

namespace pleura {

/// Registers the nodes that every scene may use without an ImportLibrary: X3D's own and those of touch.
/// Throws DuplicateTypeError where one is registered already.
void registerBuiltInNodes(NodeRegistry& registry);

}  // namespace pleura
