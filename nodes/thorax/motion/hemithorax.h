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

/// The long axis of a side, from the middle of its rim of the diaphragm up to half-way between the middle of
/// rib 1's ring and the lung's apex, and the height above its middle where the wall closes over the lung,
/// [m].
struct HemithoraxEnds {
  Eigen::Vector3d low;
  Eigen::Vector3d high;
  double cupola;
};

/// Throws std::invalid_argument when the anatomy lacks the side's lung or rim of the diaphragm.
HemithoraxEnds hemithoraxEnds(const Anatomy& anatomy, Side side);

/// How surfaces slide on a wall, from the edge of the diaphragm's dome and from its rim; `foldDrop` [m] as in
/// DomeMotion. Of the diaphragm, mesh and s are read.
WallSlide slideOf(const PleuralWall& wall, const Diaphragm& diaphragm, Side side, double foldDrop);

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
