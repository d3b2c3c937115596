#include <algorithm>
#include <stdexcept>

#include <pleura/nodes/thorax/motion/diaphragm_motion.h>

namespace pleura {
namespace {

constexpr float kNearWall = 0.010f;  // [m] a point of the zone of apposition farther from the wall is free

struct Tendon {
  std::vector<int> points;
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();
};

Tendon tendonOf(const Diaphragm& diaphragm) {
  Tendon tendon;
  for (std::size_t i = 0; i < diaphragm.part.size(); ++i) {
    if (diaphragm.part[i] != DiaphragmPart::Tendon) continue;
    tendon.points.push_back(static_cast<int>(i));
    tendon.centre += diaphragm.mesh.points[i].cast<double>();
  }
  if (tendon.points.empty()) throw std::invalid_argument("DiaphragmMotion: no point is tagged as tendon");
  tendon.centre /= static_cast<double>(tendon.points.size());
  return tendon;
}

std::vector<int> drivenPoints(const std::vector<int>& tendon, const std::vector<int>& origins,
                              const std::array<std::vector<WallFollower>, 2>& onWall) {
  std::vector<int> driven = tendon;
  driven.insert(driven.end(), origins.begin(), origins.end());
  for (const std::vector<WallFollower>& side : onWall) {
    for (const WallFollower& follower : side) driven.push_back(follower.index);
  }
  std::sort(driven.begin(), driven.end());
  return driven;
}

std::size_t sideOf(const Eigen::Vector3f& point) { return point.x() >= 0.0f ? 0 : 1; }

}  // namespace

DiaphragmMotion::DiaphragmMotion(const Diaphragm& diaphragm, const Sides& sides, const DomeMotion& dome)
    : dome_(dome), rest_(diaphragm.mesh.points), displacement_(rest_.size(), Eigen::Vector4f::Zero()) {
  if (diaphragm.part.size() != rest_.size()) {
    throw std::invalid_argument("DiaphragmMotion: part must have one tag a point");
  }
  Tendon tendon = tendonOf(diaphragm);
  tendonCentre_ = tendon.centre;
  tendon_ = std::move(tendon.points);
  std::vector<WallFollower> onSpine;
  std::vector<int> origins;
  // Rim away from the ribs borders an opening, or is a crus' origin if the tendon never comes so low.
  const double lowestTendon = tendonCentre_.y() - dome_.descent;
  for (std::size_t i = 0; i < rest_.size(); ++i) {
    const bool isRim = diaphragm.part[i] == DiaphragmPart::Rim;
    if (!isRim && diaphragm.part[i] != DiaphragmPart::Wall) continue;
    const std::size_t side = sideOf(rest_[i]);
    const WallPoint place = bindToWall(sides[side].wall, sides[side].slide, rest_[i].cast<double>());
    const bool isNear = place.bound && place.distance < kNearWall;
    const WallFollower follower{static_cast<int>(i), place};
    if (place.bound && !place.onSpine && (isNear || isRim)) {
      onWall_[side].push_back(follower);
    } else if (isNear) {
      onSpine.push_back(follower);
    } else if (isRim && rest_[i].y() < lowestTendon) {
      origins.push_back(follower.index);
    }
  }
  // Crura slide on the spine; without them what is near it is a border of the hiatus, and free.
  if (!origins.empty()) {
    for (const WallFollower& follower : onSpine)
      onWall_[sideOf(rest_[static_cast<std::size_t>(follower.index)])].push_back(follower);
  }
  driven_ = drivenPoints(tendon_, origins, onWall_);
  fill_ = HarmonicFill(diaphragm.mesh, driven_);
}

void DiaphragmMotion::move(const Sides& sides, const WallsNow& walls, double inflation,
                           std::span<Eigen::Vector3f> points) {
  const double contraction = diaphragmContraction(inflation);
  const BodyDisplacement tendon = displacementOf(tendonMotion(dome_, tendonCentre_, contraction));
  for (const int i : tendon_) {
    displacement_[static_cast<std::size_t>(i)] = tendon * rest_[static_cast<std::size_t>(i)].homogeneous();
  }
  for (std::size_t side = 0; side < 2; ++side) {
    displaceFollowers(sides[side], walls[side], onWall_[side], contraction, displacement_);
  }
  fill_.fill(displacement_);
  for (std::size_t i = 0; i < rest_.size(); ++i) points[i] = rest_[i] + displacement_[i].head<3>();
}

}  // namespace pleura
