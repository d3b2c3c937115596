#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>
#include <sstream>
#include <string>
#include <vector>

#include <pleura/nodes/deformable/mesh/surface_query.h>
#include <pleura/nodes/thorax/motion/thorax_motion.h>

namespace pleura {

/// Worst value of something and where it was found.
struct Worst {
  double value = 0.0;  // [m]
  std::string where;

  void take(double candidate, const std::string& name, const Eigen::Vector3f& at) {
    if (candidate <= value) return;
    std::ostringstream text;
    text << name << " (" << 1000.0f * at.transpose() << ") mm";
    value = candidate;
    where = text.str();
  }
};

struct Contact {
  Worst gapGrowth;    // lung surface to chest wall or diaphragm, more than at rest
  Worst liftOff;      // dome of the diaphragm to the lung above, more than at rest
  Worst penetration;  // lung into bone, cartilage or diaphragm, and the reverse
  Worst throughWall;  // diaphragm into bone or cartilage, more than at rest
};

/// Measures contact in a thorax by nearest points and signed distances between its meshes, independent of how
/// it is moved. The chest wall is the surface over ribs and intercostal spaces.
class ContactProbe {
 public:
  ContactProbe(const Anatomy& anatomy, ThoraxMotion& motion) : anatomy_(anatomy), motion_(motion) {
    for (const Rib& part : anatomy.ribs)
      add(part.name, part.mesh, rigidWith(ribBody(part.side, part.number)));
    for (std::size_t k = 0; k < anatomy.cartilages.size(); ++k) {
      bones_.push_back(
          {anatomy.cartilages[k].name, &anatomy.cartilages[k].mesh, motion.cage().cartilageWeights(k)});
    }
    add("STERNUM", anatomy.sternum.mesh, rigidWith(kSternum));
    for (const Vertebra& part : anatomy.vertebrae) add(part.name, part.bone, {});
    motion.evaluate(0.0);
    gapAtRest_ = gaps();
    liftAtRest_ = lifts();
    depthAtRest_ = diaphragmDepths();
  }

  Contact measure(double inflation) {
    motion_.evaluate(inflation);
    Contact contact;
    const auto gap = gaps();
    for (std::size_t side = 0; side < 2; ++side) {
      const Lung& lung = anatomy_.lungs[side];
      for (std::size_t i = 0; i < gap[side].size(); ++i) {
        if (lung.part[i] == LungPart::Mediastinal || gapAtRest_[side][i] > kNear) continue;
        contact.gapGrowth.take(gap[side][i] - gapAtRest_[side][i], lung.name, lung.mesh.points[i]);
      }
    }
    const auto lift = lifts();
    const auto depth = diaphragmDepths();
    for (std::size_t i = 0; i < lift.size(); ++i) {
      const Eigen::Vector3f& at = anatomy_.diaphragm.mesh.points[i];
      if (liftAtRest_[i] < kNear) contact.liftOff.take(lift[i] - liftAtRest_[i], "DIAPHRAGM", at);
      contact.throughWall.take(depth[i] - std::max(depthAtRest_[i], 0.0), "DIAPHRAGM", at);
    }
    penetrate(contact.penetration);
    return contact;
  }

 private:
  static constexpr double kNear = 0.010;  // [m] what counts as being in contact at rest
  static constexpr double kDoubtful = 0.0005;
  struct Bone {
    std::string name;
    const TriangleMesh* mesh;
    std::vector<BodyWeights> weights;
  };

  void add(const std::string& name, const TriangleMesh& mesh, const BodyWeights& weights) {
    bones_.push_back({name, &mesh, std::vector<BodyWeights>(mesh.points.size(), weights)});
  }

  SurfaceQuery moved(const Bone& bone) const {
    std::vector<Eigen::Vector3f> now(bone.mesh->points.size());
    carryAll(bone.mesh->points, bone.weights, displacementsOf(motion_.bodies()), now);
    return {now, bone.mesh->triangles};
  }

  SurfaceQuery wall(std::size_t side) const {
    std::vector<Eigen::Vector3f> now;
    for (const Eigen::Vector4f& p : motion_.walls()[side]) now.push_back(p.head<3>());
    return {now, wallTriangles(motion_.sides()[side].wall)};
  }

  SurfaceQuery diaphragm() const { return {motion_.diaphragm(), anatomy_.diaphragm.mesh.triangles}; }
  SurfaceQuery lung(std::size_t side) const {
    return {motion_.lung(side), anatomy_.lungs[side].mesh.triangles};
  }

  /// Times that a closed surface winds around a point: sum of solid angles over 4 pi (Jacobson et al. 2013).
  static double windingNumber(const SurfaceQuery& surface, const Eigen::Vector3d& point) {
    double sum = 0.0;
    for (const Eigen::Vector3i& t : surface.triangles()) {
      const auto side = [&](int k) -> Eigen::Vector3d {
        return surface.points()[static_cast<std::size_t>(t[k])].cast<double>() - point;
      };
      const Eigen::Vector3d a = side(0);
      const Eigen::Vector3d b = side(1);
      const Eigen::Vector3d c = side(2);
      const double la = a.norm();
      const double lb = b.norm();
      const double lc = c.norm();
      sum +=
          2.0 * std::atan2(a.dot(b.cross(c)), la * lb * lc + a.dot(b) * lc + b.dot(c) * la + c.dot(a) * lb);
    }
    return sum / (4.0 * std::numbers::pi);
  }

  /// Depth of a point inside a closed surface [m]; none (negative) where it is not near. Where the surface
  /// touches itself the sign of the nearest face can err, so the winding number has the last word.
  static double depthIn(const SurfaceQuery& surface, const Eigen::Vector3f& point) {
    const Eigen::Vector3d p = point.cast<double>();
    if (!surface.closestPointWithin(p, kNear)) return -kNear;
    const double depth = -surface.signedDistance(p);
    return depth > kDoubtful && windingNumber(surface, p) < 0.5 ? -depth : depth;
  }

  std::array<std::vector<double>, 2> gaps() const {
    std::array<std::vector<double>, 2> gap;
    const SurfaceQuery below = diaphragm();
    for (std::size_t side = 0; side < 2; ++side) {
      const SurfaceQuery around = wall(side);
      for (const Eigen::Vector3f& point : motion_.lung(side)) {
        const Eigen::Vector3d p = point.cast<double>();
        gap[side].push_back(std::min(around.closestPoint(p).distance, below.closestPoint(p).distance));
      }
    }
    return gap;
  }

  std::vector<double> lifts() const {
    std::vector<double> lift;
    const SurfaceQuery left = lung(0);
    const SurfaceQuery right = lung(1);
    for (std::size_t i = 0; i < motion_.diaphragm().size(); ++i) {
      const Eigen::Vector3d p = motion_.diaphragm()[i].cast<double>();
      const bool dome = anatomy_.diaphragm.part[i] == DiaphragmPart::Tendon ||
                        anatomy_.diaphragm.part[i] == DiaphragmPart::Dome;
      lift.push_back(dome ? std::min(left.closestPoint(p).distance, right.closestPoint(p).distance) : kNear);
    }
    return lift;
  }

  std::vector<double> diaphragmDepths() const {
    std::vector<double> depth(motion_.diaphragm().size(), -kNear);
    for (const Bone& bone : bones_) {
      const SurfaceQuery surface = moved(bone);
      for (std::size_t i = 0; i < depth.size(); ++i) {
        depth[i] = std::max(depth[i], depthIn(surface, motion_.diaphragm()[i]));
      }
    }
    return depth;
  }

  void penetrate(Worst& worst) const {
    const std::array<SurfaceQuery, 2> lungs{lung(0), lung(1)};
    for (std::size_t side = 0; side < 2; ++side) {
      for (const Eigen::Vector3f& p : motion_.diaphragm())
        worst.take(depthIn(lungs[side], p), "diaphragm in lung", p);
    }
    for (const Bone& bone : bones_) {
      const SurfaceQuery surface = moved(bone);
      for (std::size_t side = 0; side < 2; ++side) {
        for (const Eigen::Vector3f& p : motion_.lung(side))
          worst.take(depthIn(surface, p), "lung in " + bone.name, p);
        for (const Eigen::Vector3f& p : surface.points())
          worst.take(depthIn(lungs[side], p), bone.name + " in lung", p);
      }
    }
  }

  const Anatomy& anatomy_;
  ThoraxMotion& motion_;
  std::vector<Bone> bones_;
  std::array<std::vector<double>, 2> gapAtRest_;
  std::vector<double> liftAtRest_;
  std::vector<double> depthAtRest_;
};

}  // namespace pleura
