#pragma once

#include <cstdint>

#include <pleura/x3d/browser/scene/scene.h>

namespace pleura {

/// FNV-1a (Fowler, Noll, Vo) over every field that can be read of every node with a DEF name, in order of the
/// names: equal bits give equal hashes on any machine. Evaluates those fields.
std::uint64_t stateHash(Scene& scene);

}  // namespace pleura
