#pragma once

#include <string>
#include <vector>

#include <pleura/nodes/core/node_registry.h>
#include <pleura/nodes/thorax/anatomy/anatomy.h>
#include <pleura/x3d/browser/anatomy/scene_file.h>

namespace pleura {

/// The organs as the thesis' scenes inline them (Jacob 2008): centimetres, a file each, ribs 1 to 11. Each
/// exports its `coordNode`; diaphragm and lungs their `deform` and a TimeSensor as well: `TimeNode`,
/// `timeLL`, `timeRL`. Meshes are coarse. `source` names where the shapes are from, `registry` knows the
/// nodes of the library "chain". The same bytes for the same anatomy.
std::vector<SceneFile> chainFiles(const Anatomy& anatomy, const NodeRegistry& registry,
                                  const std::string& source);

}  // namespace pleura
