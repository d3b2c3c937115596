#include <pleura/nodes/thorax/motion/cage_motion.h>
#include <pleura/nodes/thorax/motion/cartilage_bend.h>
#include <pleura/nodes/thorax/motion/rigid_fit.h>

namespace pleura {
namespace {

/// What carries a point of a cartilage's centreline at fraction t.
BodyWeights carriedAt(const Anatomy& anatomy, const Cartilage& cartilage, double t);

/// What carries the end of a cartilage: the sternum, or the cartilage above where it is joined.
BodyWeights carriedAtEnd(const Anatomy& anatomy, const Cartilage& part) {
  if (part.joins == 0) return rigidWith(kSternum);
  const Cartilage& above = cartilage(anatomy, part.side, part.joins);
  return carriedAt(anatomy, above, fractionAlong(above.centreline, part.end));
}

BodyWeights carriedAt(const Anatomy& anatomy, const Cartilage& cartilage, double t) {
  return mix(rigidWith(ribBody(cartilage.side, cartilage.number)), carriedAtEnd(anatomy, cartilage),
             cartilageBlend(t));
}

}  // namespace

BodyDisplacements displacementsOf(const BodyMotions& motions) {
  BodyDisplacements displacements;
  for (std::size_t k = 0; k < motions.size(); ++k) displacements[k] = displacementOf(motions[k]);
  return displacements;
}

CageMotion::CageMotion(const Anatomy& anatomy, const std::array<RibAngles, 12>& left,
                       const std::array<RibAngles, 12>& right) {
  for (const Rib& part : anatomy.ribs) {
    const auto body = static_cast<std::size_t>(ribBody(part.side, part.number));
    const auto k = static_cast<std::size_t>(part.number - 1);
    angles_[body] = part.side == Side::Left ? left[k] : right[k];
    heads_[body] = part.head.cast<double>();
    if (part.number <= 7)
      sternalEnds_[k + (part.side == Side::Left ? 0 : 7)] = part.sternalEnd.cast<double>();
  }
  for (const Cartilage& part : anatomy.cartilages) {
    cartilages_.push_back(bendCartilage(part.mesh.points, part.centreline,
                                        rigidWith(ribBody(part.side, part.number)),
                                        carriedAtEnd(anatomy, part)));
  }
}

BodyMotions CageMotion::bodies(double inflation) const {
  BodyMotions motions;
  for (std::size_t k = 0; k < angles_.size(); ++k) {
    motions[k] = rotationAbout(ribRotation(angles_[k], inflation), heads_[k]);
  }
  std::array<Eigen::Vector3d, 14> moved;
  for (std::size_t k = 0; k < moved.size(); ++k) {
    const Side side = k < 7 ? Side::Left : Side::Right;
    moved[k] =
        motions[static_cast<std::size_t>(ribBody(side, static_cast<int>(k % 7) + 1))] * sternalEnds_[k];
  }
  motions[kSternum] = fitRigid(sternalEnds_, moved);
  return motions;
}

}  // namespace pleura
