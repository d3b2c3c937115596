#pragma once

#include <pleura/nodes/core/node_registry.h>

namespace pleura {

/// Registers X3D's own nodes: one line a type. Throws DuplicateTypeError where one is registered already.
void registerStandardNodes(NodeRegistry& registry);

}  // namespace pleura
