#pragma once

#include <array>
#include <cstdint>

#include <Eigen/Geometry>

#include <pleura/haptics/contact/touch_mesh.h>
#include <pleura/haptics/contact/touch_surface.h>
#include <pleura/haptics/contact/triangle_point.h>

namespace pleura::haptics {

/// A touchable shape at one instant: its points are (1 - s) from + s to, in a frame that stands in the world
/// at `pose`. What is pointed to outlives the call that it is given to.
struct TouchShape {
  std::uint32_t id = 0;  // the same in every instant
  const TouchMesh* mesh = nullptr;
  const TouchMeshFrame* from = nullptr;
  const TouchMeshFrame* to = nullptr;  // the same as `from` for a rigid shape
  float s = 1;                         // 0..1
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  TouchSurface surface;
};

/// A triangle's corners in the world.
Corners cornersOf(const TouchShape& shape, int triangle);

/// The direction outwards at a place on a triangle, not of unit length: on an edge the sum of its faces' unit
/// normals, at a corner weighted by their angles there (Baerentzen and Aanaes 2005). What is nearest to a
/// point is seen from the front where this and the way to the point make less than a right angle.
Eigen::Vector3d outward(const TouchShape& shape, int triangle, const Eigen::Vector3d& weights);

/// The triangles whose boxes reach into the ball of that radius [m] about a point of the world;
/// visit(triangle) returns false to end. No triangle that is nearer than the radius is left out. Not for
/// points beyond a float's range.
template <class Visit>
void visitNear(const TouchShape& shape, const Eigen::Vector3d& point, double radius, Visit visit);

template <class Visit>
void visitNear(const TouchShape& shape, const Eigen::Vector3d& point, double radius, Visit visit) {
  // the boxes are of floats, and those between two frames are rounded: so much more is asked for
  constexpr float rounding = 1e-6F;
  constexpr int stackSize = 64;  // 3 children wait on each of at most 16 levels: 4^16 > 2^31 triangles
  const Eigen::Vector3f p = (shape.pose.inverse(Eigen::Isometry) * point).cast<float>();
  const FourNumbers place(p[0], p[1], p[2], 0);
  const float reach = static_cast<float>(radius) * (1 + rounding) + rounding * place.abs().maxCoeff();
  const float squaredReach = reach * reach;
  const bool moves = shape.from != shape.to;
  const auto squaredDistance = [&](int triangle) {
    const Eigen::Vector3i& t = shape.mesh->triangles()[triangle];
    std::array<FourNumbers, 3> corners;
    for (int k = 0; k < 3; ++k) {
      corners[k] = shape.from->points[t[k]];
      if (moves) corners[k] += shape.s * (shape.to->points[t[k]] - corners[k]);
    }
    const FourNumbers low = corners[0].min(corners[1]).min(corners[2]);
    const FourNumbers high = corners[0].max(corners[1]).max(corners[2]);
    return (low - place).max(place - high).max(0.0F).square().sum();
  };
  std::array<int, stackSize> stack;
  int size = 0;
  stack[size++] = 0;
  while (size > 0) {
    const int index = stack[--size];
    const TouchMesh::Node& node = shape.mesh->nodes()[index];
    FourBoxes boxes = shape.from->boxes[index];
    if (moves) {
      boxes.low += shape.s * (shape.to->boxes[index].low - boxes.low);
      boxes.high += shape.s * (shape.to->boxes[index].high - boxes.high);
    }
    const FourNumbers squared = boxes.squaredDistance(p);
    // told first and visited then: a branch for each would be guessed wrong every other time
    std::array<int, std::size_t{4} * TouchMesh::kLeafSize> near;
    int count = 0;
    for (int c = 0; c < node.childCount; ++c) {
      if (squared[c] > squaredReach) continue;
      const auto [first, triangles] = node.children[c];
      if (triangles == 0) stack[size++] = first;
      for (int i = first; i < first + triangles; ++i) {
        near[count] = i;
        count += squaredDistance(i) <= squaredReach;
      }
    }
    for (int i = 0; i < count; ++i)
      if (!visit(near[i])) return;
  }
}

}  // namespace pleura::haptics
