#pragma once

#include <pleura/nodes/thorax/motion/cage_motion.h>
#include <pleura/nodes/thorax/motion/diaphragm_motion.h>
#include <pleura/nodes/thorax/motion/lung_motion.h>

namespace pleura {

/// The whole thorax as a function of one scalar.
class ThoraxMotion {
 public:
  explicit ThoraxMotion(const Anatomy& anatomy, const DomeMotion& dome = {},
                        const std::array<RibAngles, 12>& left = measuredRibAngles(1.0),
                        const std::array<RibAngles, 12>& right = measuredRibAngles(-1.0));

  /// Moves everything to an inflation: 0 FRC, 1 TLC. No memory, no allocation.
  void evaluate(double inflation);

  const BodyMotions& bodies() const { return bodies_; }
  const CageMotion& cage() const { return cage_; }
  const Sides& sides() const { return sides_; }
  const std::array<std::vector<Eigen::Vector4f>, 2>& walls() const { return walls_; }
  const std::vector<Eigen::Vector3f>& diaphragm() const { return diaphragmPoints_; }
  const std::vector<Eigen::Vector3f>& lung(std::size_t side) const { return lungPoints_[side]; }
  const DiaphragmMotion& diaphragmMotion() const { return diaphragm_; }
  const LungMotion& lungMotion(std::size_t side) const { return lungs_[side]; }

 private:
  CageMotion cage_;
  Sides sides_;
  DiaphragmMotion diaphragm_;
  std::array<LungMotion, 2> lungs_;
  BodyMotions bodies_;
  std::array<std::vector<Eigen::Vector4f>, 2> walls_;
  std::vector<Eigen::Vector3f> diaphragmPoints_;
  std::array<std::vector<Eigen::Vector3f>, 2> lungPoints_;
};

}  // namespace pleura
