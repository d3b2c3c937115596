#pragma once

#include <cstdint>
#include <span>

#include <Eigen/Core>

namespace pleura::render {

/// Unit normals out[i] of a smooth surface at positions[i]: the area-weighted mean of the triangles around a
/// vertex, zero where they cancel or there is none. `triangles` holds three indices a triangle, all below
/// positions.size(), which is also the size of `out`. Does not allocate.
void smoothNormals(std::span<const Eigen::Vector3f> positions, std::span<const std::uint32_t> triangles,
                   std::span<Eigen::Vector3f> out);

}  // namespace pleura::render
