#pragma once

#include <array>
#include <span>
#include <vector>

#include <pleura/nodes/thorax/anatomy/anatomy.h>
#include <pleura/nodes/thorax/motion/rib_motion.h>
#include <pleura/nodes/thorax/motion/skin.h>

namespace pleura {

/// The rigid bodies of the cage: ribs L1-L12, R1-R12, sternum. The spine stays.
inline constexpr int kSternum = 24;
inline constexpr int kBodies = 25;
using BodyMotions = std::array<Eigen::Isometry3d, kBodies>;
using BodyDisplacements = std::array<BodyDisplacement, kBodies>;

BodyDisplacements displacementsOf(const BodyMotions& motions);

/// Index of a rib among the bodies, number 1-12.
constexpr int ribBody(Side side, int number) { return (side == Side::Left ? 0 : 12) + number - 1; }

/// What one scalar does to the bones: ribs turn about their heads, the sternum is fitted to the sternal ends
/// of ribs 1-7, cartilages bend between the two.
class CageMotion {
 public:
  CageMotion(const Anatomy& anatomy, const std::array<RibAngles, 12>& left,
             const std::array<RibAngles, 12>& right);

  /// Motions of all bodies from rest. Throws std::invalid_argument when the inflation is not finite.
  BodyMotions bodies(double inflation) const;

  /// What carries each point of a cartilage; `cartilage` counts as in Anatomy::cartilages.
  const std::vector<BodyWeights>& cartilageWeights(std::size_t cartilage) const {
    return cartilages_[cartilage];
  }

 private:
  std::array<RibAngles, 24> angles_;
  std::array<Eigen::Vector3d, 24> heads_;
  std::array<Eigen::Vector3d, 14> sternalEnds_;  // of ribs 1-7, left then right
  std::vector<std::vector<BodyWeights>> cartilages_;
};

}  // namespace pleura
