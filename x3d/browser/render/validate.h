#pragma once

#include <pleura/x3d/browser/render/draw_list.h>

namespace pleura::render {

/// Throws std::invalid_argument that names the bad value of the list, streams of geometries aside.
void validate(const DrawList& list);

}  // namespace pleura::render
