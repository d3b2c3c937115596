#include <algorithm>
#include <stdexcept>

#include <pleura/nodes/thorax/motion/diaphragm_motion.h>

namespace pleura {
namespace {

constexpr float kNearWall = 0.008f;  // [m] a wall or rim point farther from the ribs belongs to the crura

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

std::vector<int> drivenPoints(const std::vector<int>& tendon,
                              const std::array<std::vector<WallFollower>, 2>& onWall) {
  std::vector<int> driven = tendon;
  for (const std::vector<WallFollower>& side : onWall) {
    for (const WallFollower& follower : side) driven.push_back(follower.index);
  }
  std::sort(driven.begin(), driven.end());
  return driven;
}

}  // namespace

DiaphragmMotion::DiaphragmMotion(const Diaphragm& diaphragm, const Sides& sides, const DomeMotion& dome)
    : dome_(dome), rest_(diaphragm.mesh.points), displacement_(rest_.size(), Eigen::Vector4f::Zero()) {
  if (diaphragm.part.size() != rest_.size()) {
    throw std::invalid_argument("DiaphragmMotion: part must have one tag a point");
  }
  Tendon tendon = tendonOf(diaphragm);
  tendonCentre_ = tendon.centre;
  tendon_ = std::move(tendon.points);
  for (std::size_t i = 0; i < rest_.size(); ++i) {
    if (diaphragm.part[i] != DiaphragmPart::Wall && diaphragm.part[i] != DiaphragmPart::Rim) continue;
    const std::size_t side = rest_[i].x() >= 0.0f ? 0 : 1;
    const WallPoint place = bindToWall(sides[side].wall, sides[side].slide, rest_[i].cast<double>());
    if (place.bound && !place.onSpine && place.distance < kNearWall) {
      onWall_[side].push_back({static_cast<int>(i), place});
    }
  }
  driven_ = drivenPoints(tendon_, onWall_);
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
