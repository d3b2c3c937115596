#pragma once

#include <span>
#include <vector>

#include <Eigen/Core>

#include <pleura/nodes/thorax/anatomy/anatomy.h>
#include <pleura/nodes/thorax/motion/cage_motion.h>
#include <pleura/nodes/thorax/motion/wall_binding.h>

namespace pleura {

/// One side of the cage as its pleura sees it: the wall, and how surfaces slide on it.
struct Hemithorax {
  PleuralWall wall;
  WallSlide slide;
};

/// Builds a side from the bones at rest; `foldDrop` [m] as in DomeMotion. Throws std::invalid_argument when
/// the anatomy lacks the side's lung or rim of the diaphragm.
Hemithorax buildHemithorax(const Anatomy& anatomy, const CageMotion& cage, Side side, double foldDrop);

/// A point of an organ that keeps its place on the wall.
struct WallFollower {
  int index = 0;
  WallPoint place;
};

/// Writes displacement[index] [m] of every follower; `wallNow` is the moved grid.
void displaceFollowers(const Hemithorax& half, std::span<const Eigen::Vector4f> wallNow,
                       std::span<const WallFollower> followers, double contraction,
                       std::span<Eigen::Vector4f> displacement);

}  // namespace pleura
