#pragma once

#include <string>
#include <vector>

#include <pleura/nodes/core/node_registry.h>
#include <pleura/nodes/thorax/anatomy/anatomy.h>
#include <pleura/x3d/browser/anatomy/scene_file.h>

namespace pleura {

/// A thorax as scene files: a file for each bone, and `thorax.x3d`, which puts them together, holds the
/// organs and exports all that a scene moves and watches. `source` names where the shapes are from,
/// `registry` knows the nodes of the thorax. The same bytes for the same anatomy.
std::vector<SceneFile> thoraxFiles(const Anatomy& anatomy, const NodeRegistry& registry,
                                   const std::string& source);

}  // namespace pleura
