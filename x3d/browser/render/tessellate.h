#pragma once

#include <cstdint>
#include <vector>

#include <Eigen/Core>

namespace pleura::render {

/// Triangles of a plane area; counterclockwise.
struct PlaneMesh {
  std::vector<Eigen::Vector2f> positions;
  std::vector<std::uint32_t> indices;  // three a triangle
};

/// The area inside closed contours by the non-zero winding rule; they may have holes, touch and cross. With
/// GLU's tessellator.
PlaneMesh tessellate(const std::vector<std::vector<Eigen::Vector2f>>& contours);

}  // namespace pleura::render
