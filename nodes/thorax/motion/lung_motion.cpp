#include <pleura/nodes/deformable/mesh/surface_query.h>
#include <pleura/nodes/thorax/motion/dome_motion.h>
#include <pleura/nodes/thorax/motion/lung_motion.h>

namespace pleura {
namespace {

constexpr float kNear = 0.015f;  // [m] a point farther from wall and diaphragm than this is not driven

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
  for (std::size_t i = 0; i < rest_.size(); ++i) {
    const int index = static_cast<int>(i);
    const Eigen::Vector3d p = rest_[i].cast<double>();
    const WallPoint place = bindToWall(half.wall, half.slide, p);
    const bool onWall = place.bound && !(place.onSpine && lung.part[i] == LungPart::Mediastinal);
    const bool nearWall = onWall && place.distance < kNear;
    const auto below = query.closestPointWithin(p, nearWall ? place.distance : kNear);
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
