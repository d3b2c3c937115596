#pragma once

#include <span>
#include <vector>

#include <pleura/nodes/thorax/anatomy/anatomy.h>
#include <pleura/nodes/thorax/motion/harmonic_fill.h>
#include <pleura/nodes/thorax/motion/hemithorax.h>

namespace pleura {

/// A lung between its wall and the diaphragm. Driven: every point near either, by the nearer one. On the wall
/// it slides, on the diaphragm it keeps its offset from the place it lay on; along both its lower border
/// advances into the opening recess. The mediastinal rest fills in harmonically.
class LungMotion {
 public:
  LungMotion(const Lung& lung, const Hemithorax& half, const TriangleMesh& diaphragm);

  /// Positions [m] at an inflation, given the moved wall and diaphragm. Does not allocate; one call at a
  /// time.
  void move(const Hemithorax& half, std::span<const Eigen::Vector4f> wallNow,
            std::span<const Eigen::Vector3f> diaphragmNow, double inflation,
            std::span<Eigen::Vector3f> points);

  /// The points that something drives, ascending.
  const std::vector<int>& driven() const { return driven_; }

 private:
  /// A place on a triangle of the diaphragm.
  struct Place {
    Eigen::Vector3i corners;
    Eigen::Vector3f barycentric;

    Eigen::Vector3f of(std::span<const Eigen::Vector3f> diaphragm) const;
  };
  /// A point that keeps its offset from a place that goes from one to another as the border advances.
  struct DiaphragmFollower {
    int index;
    Place from, to;
    Eigen::Vector3f foot;  // [m] where it is at rest
  };

  std::vector<Eigen::Vector3f> rest_;
  std::vector<WallFollower> onWall_;
  std::vector<DiaphragmFollower> onDiaphragm_;
  std::vector<int> driven_;
  HarmonicFill fill_;
  std::vector<Eigen::Vector4f> displacement_;
};

}  // namespace pleura
