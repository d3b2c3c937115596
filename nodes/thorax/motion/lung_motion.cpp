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

  /// WallPoint::advance of a place beside the wall. What is far from the surface it slides on by `offset`
  /// [m], or from the wall, keeps back.
  float advance(const WallPoint& place, float offset) const {
    constexpr float kReach = 0.025f;  // [m]
    if (!place.bound) return 0.0f;
    const float v =
        (1.0f - place.fraction) * at(place.column) + place.fraction * at(PleuralWall::next(place.column));
    const float t = std::min(place.v / v, 1.0f);
    return std::max(kLowest - v, 0.0f) * t * t * t * kept(place.distance / kReach) * kept(offset / kNear);
  }

 private:
  static constexpr float kHighest = 0.85f;  // a border farther up belongs to the heart's notch
  static constexpr float kLowest = 0.988f;  // at contraction 1; some room for the lung's thickness

  /// Falls from 1 at 0 to 0 at 1.
  static float kept(float away) { return std::max(1.0f - away * away, 0.0f); }

  float& at(int column) { return v_[static_cast<std::size_t>(column)]; }
  float at(int column) const { return v_[static_cast<std::size_t>(column)]; }

  std::array<float, PleuralWall::kColumns> v_{};
};

/// Where one comes to from a place on a surface by going a way [m] as far as it leads along the surface.
SurfacePoint walk(const SurfaceQuery& surface, const Eigen::Vector3d& from, const Eigen::Vector3d& way) {
  constexpr int kSteps = 8;
  SurfacePoint at = surface.closestPoint(from);
  for (int k = 0; k < kSteps; ++k) at = surface.closestPoint(at.point + way / kSteps);
  return at;
}

}  // namespace

Eigen::Vector3f LungMotion::Place::of(std::span<const Eigen::Vector3f> diaphragm) const {
  Eigen::Vector3f point = Eigen::Vector3f::Zero();
  for (int k = 0; k < 3; ++k) {
    point += barycentric[k] * diaphragm[static_cast<std::size_t>(corners[k])];
  }
  return point;
}

LungMotion::LungMotion(const Lung& lung, const Hemithorax& half, const TriangleMesh& diaphragm)
    : rest_(lung.mesh.points), displacement_(rest_.size(), Eigen::Vector4f::Zero()) {
  const SurfaceQuery query(diaphragm.points, diaphragm.triangles);
  const auto placeOf = [&](const SurfacePoint& on) {
    return Place{diaphragm.triangles[static_cast<std::size_t>(on.triangle)], on.barycentric.cast<float>()};
  };
  LowerBorder border;
  std::vector<WallPoint> beside;  // one a follower of the diaphragm
  for (std::size_t i = 0; i < rest_.size(); ++i) {
    const int index = static_cast<int>(i);
    const Eigen::Vector3d p = rest_[i].cast<double>();
    const WallPoint place = bindToWall(half.wall, half.slide, p);
    const bool onWall = place.bound && !(place.onSpine && lung.part[i] == LungPart::Mediastinal);
    const bool nearWall = onWall && place.distance < kNear;
    const auto below = query.closestPointWithin(p, nearWall ? place.distance : kNear);
    if (nearWall && !place.onSpine && query.closestPointWithin(p, kNear)) border.take(place);
    if (below) {
      const Place from = placeOf(*below);
      onDiaphragm_.push_back({index, from, from, from.of(diaphragm.points)});
      beside.push_back(place);
    } else if (nearWall) {
      onWall_.push_back({index, place});
    }
    if (below || nearWall) driven_.push_back(index);
  }
  border.smooth();
  for (WallFollower& follower : onWall_) {
    follower.place.advance = border.advance(follower.place, 0.0f);
  }
  for (std::size_t i = 0; i < beside.size(); ++i) {
    DiaphragmFollower& follower = onDiaphragm_[i];
    WallPoint place = beside[i];
    const float advance =
        border.advance(place, (rest_[static_cast<std::size_t>(follower.index)] - follower.foot).norm());
    if (advance == 0.0f) continue;
    place.v += advance;
    const Eigen::Vector4f way = followWall(half.wall, half.wall.rest, half.slide, place, 0.0) - place.rest;
    follower.to = placeOf(walk(query, follower.foot.cast<double>(), way.head<3>().cast<double>()));
  }
  fill_ = HarmonicFill(lung.mesh, driven_);
}

void LungMotion::move(const Hemithorax& half, std::span<const Eigen::Vector4f> wallNow,
                      std::span<const Eigen::Vector3f> diaphragmNow, double inflation,
                      std::span<Eigen::Vector3f> points) {
  const double contraction = diaphragmContraction(inflation);
  displaceFollowers(half, wallNow, onWall_, contraction, displacement_);
  const auto t = static_cast<float>(advanceMade(contraction));
  for (const DiaphragmFollower& f : onDiaphragm_) {
    displacement_[static_cast<std::size_t>(f.index)].head<3>() =
        (1.0f - t) * f.from.of(diaphragmNow) + t * f.to.of(diaphragmNow) - f.foot;
  }
  fill_.fill(displacement_);
  for (std::size_t i = 0; i < rest_.size(); ++i) points[i] = rest_[i] + displacement_[i].head<3>();
}

}  // namespace pleura
