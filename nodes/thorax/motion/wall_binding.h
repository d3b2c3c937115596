#pragma once

#include <span>

#include <Eigen/Core>

#include <pleura/nodes/thorax/motion/pleural_wall.h>
#include <pleura/nodes/thorax/motion/wall_slide.h>

namespace pleura {

/// A place near the wall: between column `column` and the next at `fraction`, at v down them, `gap` inwards.
struct WallPoint {
  Eigen::Vector4f rest = Eigen::Vector4f::Zero();  // (x, y, z, 1) of that place at rest, m
  int column = 0;
  float fraction = 0.0f;  // [0, 1)
  float v = 0.0f;
  float advance = 0.0f;   // added to v at contraction 1
  float gap = 0.0f;       // [m] along the inward normal, negative outside
  float lift = 0.0f;      // [m] added to the gap while the point slides
  float distance = 0.0f;  // [m] of the asked point from the wall
  bool bound = false;     // false where the cage is open (mediastinum)
  bool onSpine = false;   // bone that doesn't move carries the wall there
};

/// Share of their advance that points have made at a contraction: c (2 - c), since the recess opens early.
constexpr double advanceMade(double contraction) { return contraction * (2.0 - contraction); }

/// The place of `point` [m]: the nearest one of the wall in its half-plane, and the gap from there.
WallPoint bindToWall(const PleuralWall& wall, const WallSlide& slide, const Eigen::Vector3d& point);

/// Where that place is on the moved wall, as (x, y, z, 1) [m]; point.rest, bit for bit, at rest.
Eigen::Vector4f followWall(const PleuralWall& wall, std::span<const Eigen::Vector4f> now,
                           const WallSlide& slide, const WallPoint& point, double contraction);

}  // namespace pleura
