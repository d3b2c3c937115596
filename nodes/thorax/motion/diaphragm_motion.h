#pragma once

#include <array>
#include <span>
#include <vector>

#include <pleura/nodes/thorax/anatomy/anatomy.h>
#include <pleura/nodes/thorax/motion/dome_motion.h>
#include <pleura/nodes/thorax/motion/harmonic_fill.h>
#include <pleura/nodes/thorax/motion/hemithorax.h>

namespace pleura {

using Sides = std::array<Hemithorax, 2>;                           // left, right
using WallsNow = std::array<std::span<const Eigen::Vector4f>, 2>;  // their moved grids

/// The diaphragm between moving walls and descending tendon. Driven: the tendon (rigid), zone of apposition
/// and rim (on the wall), crura (on the spine, their origins at rest). The muscle of the dome and the crura
/// between tendon and spine fill in harmonically.
class DiaphragmMotion {
 public:
  /// Throws std::invalid_argument when no point is tagged as tendon or the tags are not one a point.
  DiaphragmMotion(const Diaphragm& diaphragm, const Sides& sides, const DomeMotion& dome);

  /// Positions [m] at an inflation, one a point of the mesh. Does not allocate; one call at a time.
  void move(const Sides& sides, const WallsNow& walls, double inflation, std::span<Eigen::Vector3f> points);

  /// The points that something drives, ascending.
  const std::vector<int>& driven() const { return driven_; }

 private:
  DomeMotion dome_;
  Eigen::Vector3d tendonCentre_;
  std::vector<Eigen::Vector3f> rest_;
  std::vector<int> tendon_;
  std::array<std::vector<WallFollower>, 2> onWall_;
  std::vector<int> driven_;
  HarmonicFill fill_;
  std::vector<Eigen::Vector4f> displacement_;
};

}  // namespace pleura
