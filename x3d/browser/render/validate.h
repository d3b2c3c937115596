#pragma once

#include <pleura/x3d/browser/render/draw_list.h>

namespace pleura::render {

// Each throws std::invalid_argument that names the bad value.
void validate(const Geometry& geometry);
void validate(const DrawItem& item);  // its geometry aside
void validate(const Light& light);
void validate(const Camera& camera);
void validate(const Background& background);
void validate(const DrawList& list);  // all that it holds, geometries and the camera's projection aside

}  // namespace pleura::render
