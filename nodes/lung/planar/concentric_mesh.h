#pragma once

#include <span>

#include <pleura/nodes/lung/planar/hemithorax.h>

namespace pleura::planar {

/// Rings of nearly equal triangles about the middle of a closed, counter-clockwise outline of 6 R points: 6
/// R^2 triangles, the outline's points first. Throws std::invalid_argument when the outline has another
/// number of points or is not seen whole from its middle.
LungMesh concentricMesh(std::span<const Eigen::Vector2d> outline);

}  // namespace pleura::planar
