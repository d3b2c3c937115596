#include <algorithm>
#include <array>

#include <pleura/nodes/deformable/mesh/surface_query.h>
#include <pleura/nodes/thorax/motion/dome_motion.h>
#include <pleura/nodes/thorax/motion/lung_motion.h>

namespace pleura {
namespace {

constexpr float kNear = 0.012f;  // [m] a point farther from wall and diaphragm than this is not driven

/// Where a lung's lower border lies between wall and diaphragm: v on each column, 1 where it has none. As the
/// dome flattens and leaves the wall, the border advances into the opening, down to the fold.
class LowerBorder {
 public:
  LowerBorder() { v_.fill(1.0f); }

  void take(const WallPoint& place) {
    for (const int column : {place.column, PleuralWall::next(place.column)}) {
      float& v = at(column);
      v = v == 1.0f ? place.v : std::max(v, place.v);
    }
  }

  void smooth() {
    constexpr int kPasses = 2;
    for (float& v : v_) v = std::clamp(v, kHighest, 1.0f);
    for (int pass = 0; pass < kPasses; ++pass) {
      LowerBorder before = *this;
      for (int c = 0; c < PleuralWall::kColumns; ++c) {
        at(c) = 0.25f * before.at(PleuralWall::previous(c)) + 0.5f * before.at(c) +
                0.25f * before.at(PleuralWall::next(c));
      }
    }
  }

  /// Of a place on the wall: WallPoint::advance.
  float advance(const WallPoint& place) {
    const float v =
        (1.0f - place.fraction) * at(place.column) + place.fraction * at(PleuralWall::next(place.column));
    const float t = std::min(place.v / v, 1.0f);
    const float away = place.distance / kNear;  // what is farther from the wall keeps back
    return std::max(kLowest - v, 0.0f) * t * t * t * (1.0f - away * away);
  }

 private:
  static constexpr float kHighest = 0.85f;  // a border farther up belongs to the heart's notch
  static constexpr float kLowest = 0.98f;   // at contraction 1; some room for the lung's thickness

  float& at(int column) { return v_[static_cast<std::size_t>(column)]; }

  std::array<float, PleuralWall::kColumns> v_{};
};

}  // namespace

Eigen::Vector3f LungMotion::footOf(const DiaphragmFollower& follower,
                                   std::span<const Eigen::Vector3f> diaphragm) {
  Eigen::Vector3f foot = Eigen::Vector3f::Zero();
  for (int k = 0; k < 3; ++k) {
    foot += follower.barycentric[k] * diaphragm[static_cast<std::size_t>(follower.corners[k])];
  }
  return foot;
}

LungMotion::LungMotion(const Lung& lung, const Hemithorax& half, const TriangleMesh& diaphragm)
    : rest_(lung.mesh.points), displacement_(rest_.size(), Eigen::Vector4f::Zero()) {
  const SurfaceQuery query(diaphragm.points, diaphragm.triangles);
  LowerBorder border;
  for (std::size_t i = 0; i < rest_.size(); ++i) {
    const int index = static_cast<int>(i);
    const Eigen::Vector3d p = rest_[i].cast<double>();
    const WallPoint place = bindToWall(half.wall, half.slide, p);
    const bool onWall = place.bound && !(place.onSpine && lung.part[i] == LungPart::Mediastinal);
    const bool nearWall = onWall && place.distance < kNear;
    const auto below = query.closestPointWithin(p, nearWall ? place.distance : kNear);
    if (nearWall && !place.onSpine && query.closestPointWithin(p, kNear)) border.take(place);
    if (below) {
      DiaphragmFollower follower{index,
                                 diaphragm.triangles[static_cast<std::size_t>(below->triangle)],
                                 below->barycentric.cast<float>(),
                                 {}};
      follower.foot = footOf(follower, diaphragm.points);
      onDiaphragm_.push_back(follower);
    } else if (nearWall) {
      onWall_.push_back({index, place});
    }
    if (below || nearWall) driven_.push_back(index);
  }
  border.smooth();
  for (WallFollower& follower : onWall_) follower.place.advance = border.advance(follower.place);
  fill_ = HarmonicFill(lung.mesh, driven_);
}

void LungMotion::move(const Hemithorax& half, std::span<const Eigen::Vector4f> wallNow,
                      std::span<const Eigen::Vector3f> diaphragmNow, double inflation,
                      std::span<Eigen::Vector3f> points) {
  displaceFollowers(half, wallNow, onWall_, diaphragmContraction(inflation), displacement_);
  for (const DiaphragmFollower& f : onDiaphragm_) {
    displacement_[static_cast<std::size_t>(f.index)].head<3>() = footOf(f, diaphragmNow) - f.foot;
  }
  fill_.fill(displacement_);
  for (std::size_t i = 0; i < rest_.size(); ++i) points[i] = rest_[i] + displacement_[i].head<3>();
}

}  // namespace pleura
