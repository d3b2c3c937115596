#pragma once

#include <algorithm>
#include <sstream>
#include <string>
#include <vector>

#include <pleura/nodes/deformable/mesh/measures.h>
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
  Worst gapGrowth;    // lung to chest wall or diaphragm, zone of apposition to wall, more than at rest
  Worst gapOfEdges;   // the same in the middles of edges: one across a lung's lower border cuts the recess
  Worst liftOff;      // dome of the diaphragm to the lung above, more than at rest
  Worst penetration;  // lung into bone, cartilage or diaphragm, and the reverse
  Worst throughWall;  // diaphragm into bone or cartilage, more than at rest
};

/// Measures contact in a thorax by nearest points and signed distances between its meshes, independent of how
/// it is moved. Of the organs it takes the points and the middles of the edges. The chest wall is the surface
/// over ribs and intercostal spaces.
class ContactProbe {
 public:
  ContactProbe(const Anatomy& anatomy, ThoraxMotion& motion)
      : anatomy_(anatomy),
        motion_(motion),
        diaphragmEdges_(edgesOf(anatomy.diaphragm.mesh)),
        lungEdges_{edgesOf(anatomy.lungs[0].mesh), edgesOf(anatomy.lungs[1].mesh)} {
    for (const Rib& part : anatomy.ribs)
      add(part.name, part.mesh, rigidWith(ribBody(part.side, part.number)));
    for (std::size_t k = 0; k < anatomy.cartilages.size(); ++k) {
      bones_.push_back(
          {anatomy.cartilages[k].name, &anatomy.cartilages[k].mesh, motion.cage().cartilageWeights(k)});
    }
    add("STERNUM", anatomy.sternum.mesh, rigidWith(kSternum));
    for (const Vertebra& part : anatomy.vertebrae) {
      add(part.name, part.bone, {});
      add(part.name + "_DISC", part.disc, {});
    }
    motion.evaluate(0.0);
    gapAtRest_ = lungGaps();
    zoneAtRest_ = zoneGaps();
    besideRibs_ = besideRibs();
    liftAtRest_ = lifts();
    depthAtRest_ = diaphragmDepths();
  }

  Contact measure(double inflation) {
    motion_.evaluate(inflation);
    Contact contact;
    const std::vector<Eigen::Vector3f> sheet = diaphragmSamples();
    const auto gap = lungGaps();
    for (std::size_t side = 0; side < 2; ++side) {
      const std::vector<Eigen::Vector3f> at = lungSamples(side);
      for (std::size_t i = 0; i < gap[side].size(); ++i) {
        if (gapAtRest_[side][i] >= kNear) continue;
        Worst& worst = i < motion_.lung(side).size() ? contact.gapGrowth : contact.gapOfEdges;
        worst.take(gap[side][i] - gapAtRest_[side][i], anatomy_.lungs[side].name, at[i]);
      }
    }
    const auto zone = zoneGaps();
    const auto lift = lifts();
    const auto depth = diaphragmDepths();
    for (std::size_t i = 0; i < sheet.size(); ++i) {
      if (besideRibs_[i] && zoneAtRest_[i] < kApposed) {
        Worst& worst = i < motion_.diaphragm().size() ? contact.gapGrowth : contact.gapOfEdges;
        worst.take(zone[i] - zoneAtRest_[i], "DIAPHRAGM off wall", sheet[i]);
      }
      if (liftAtRest_[i] < kNear) contact.liftOff.take(lift[i] - liftAtRest_[i], "DIAPHRAGM", sheet[i]);
      contact.throughWall.take(depth[i] - std::max(depthAtRest_[i], 0.0), "DIAPHRAGM", sheet[i]);
    }
    penetrate(contact.penetration);
    return contact;
  }

 private:
  static constexpr double kNear = 0.010;         // [m] what counts as being in contact at rest
  static constexpr double kApposed = 0.005;      // [m] diaphragm to wall, no lung between them
  static constexpr double kBetweenRibs = 0.010;  // [m] from the nearest rib; below the last there is no wall
  static constexpr double kDoubtful = 0.0005;
  using Edges = std::vector<Eigen::Vector2i>;
  struct Bone {
    std::string name;
    const TriangleMesh* mesh;
    std::vector<BodyWeights> weights;
  };

  static Edges edgesOf(const TriangleMesh& mesh) { return edges(mesh.points.size(), mesh.triangles); }

  static std::vector<Eigen::Vector3f> samples(std::vector<Eigen::Vector3f> points, const Edges& edges) {
    for (const Eigen::Vector2i& e : edges) {
      points.push_back(0.5f *
                       (points[static_cast<std::size_t>(e[0])] + points[static_cast<std::size_t>(e[1])]));
    }
    return points;
  }
  std::vector<Eigen::Vector3f> diaphragmSamples() const {
    return samples(motion_.diaphragm(), diaphragmEdges_);
  }
  std::vector<Eigen::Vector3f> lungSamples(std::size_t side) const {
    return samples(motion_.lung(side), lungEdges_[side]);
  }

  /// Whether the ends of a sample, a point or the middle of an edge, all fulfil something.
  template <class OfPoint>
  static bool holds(std::size_t sample, std::size_t points, const Edges& edges, const OfPoint& ofPoint) {
    if (sample < points) return ofPoint(sample);
    const Eigen::Vector2i& e = edges[sample - points];
    return ofPoint(static_cast<std::size_t>(e[0])) && ofPoint(static_cast<std::size_t>(e[1]));
  }

  void add(const std::string& name, const TriangleMesh& mesh, const BodyWeights& weights) {
    bones_.push_back({name, &mesh, std::vector<BodyWeights>(mesh.points.size(), weights)});
  }

  SurfaceQuery moved(const Bone& bone) const {
    std::vector<Eigen::Vector3f> now(bone.mesh->points.size());
    carryAll(bone.mesh->points, bone.weights, displacementsOf(motion_.bodies()), now);
    return {now, bone.mesh->triangles};
  }

  /// The wall with its columns read at the same distances from the cupola, so that no triangle is skewed.
  SurfaceQuery wall(std::size_t side) const {
    const PleuralWall& rest = motion_.sides()[side].wall;
    const double step = *std::max_element(rest.spacing.begin(), rest.spacing.end());
    std::vector<Eigen::Vector3f> now;
    for (int c = 0; c < PleuralWall::kColumns; ++c) {
      const double spacing = rest.open(c) ? step : rest.spacing[static_cast<std::size_t>(c)];
      for (int r = 0; r < PleuralWall::kRows; ++r) {
        const double row = std::min(r * step / spacing, PleuralWall::kRows - 1.0);
        const int above = std::min(static_cast<int>(row), PleuralWall::kRows - 2);
        const auto t = static_cast<float>(row - above);
        const Eigen::Vector4f& a = motion_.walls()[side][PleuralWall::index(c, above)];
        const Eigen::Vector4f& b = motion_.walls()[side][PleuralWall::index(c, above + 1)];
        now.push_back(((1.0f - t) * a + t * b).head<3>());
      }
    }
    return {now, wallTriangles(rest)};
  }

  SurfaceQuery diaphragm() const { return {motion_.diaphragm(), anatomy_.diaphragm.mesh.triangles}; }
  SurfaceQuery lung(std::size_t side) const {
    return {motion_.lung(side), anatomy_.lungs[side].mesh.triangles};
  }

  /// Depth of a point inside a closed surface [m]; none (negative) where it is not near. Where the surface
  /// touches itself the sign of the nearest face can err, so the winding number has the last word.
  static double depthIn(const SurfaceQuery& surface, const Eigen::Vector3f& point) {
    const Eigen::Vector3d p = point.cast<double>();
    if (!surface.closestPointWithin(p, kNear)) return -kNear;
    const double depth = -surface.signedDistance(p);
    return depth > kDoubtful && windingNumber(surface.points(), surface.triangles(), p) < 0.5 ? -depth
                                                                                              : depth;
  }

  /// How far a point lies under the sheet of the diaphragm [m]; none (negative) where it is not near or
  /// beside its border.
  double depthUnder(const SurfaceQuery& sheet, const Eigen::Vector3f& point) const {
    const Eigen::Vector3d p = point.cast<double>();
    const auto nearest = sheet.closestPointWithin(p, kNear);
    if (!nearest) return -kNear;
    const double depth = -sheet.pseudonormal(*nearest).normalized().dot(p - nearest->point);
    return depth > 0.8 * nearest->distance ? nearest->distance : -nearest->distance;
  }

  std::array<std::vector<double>, 2> lungGaps() const {
    std::array<std::vector<double>, 2> gap;
    const SurfaceQuery below = diaphragm();
    for (std::size_t side = 0; side < 2; ++side) {
      const SurfaceQuery around = wall(side);
      const Lung& lung = anatomy_.lungs[side];
      const std::vector<Eigen::Vector3f> at = lungSamples(side);
      gap[side].assign(at.size(), kNear);
      for (std::size_t i = 0; i < at.size(); ++i) {
        const bool faces = holds(i, lung.part.size(), lungEdges_[side],
                                 [&](std::size_t k) { return lung.part[k] != LungPart::Mediastinal; });
        if (!faces) continue;
        const Eigen::Vector3d p = at[i].cast<double>();
        gap[side][i] = std::min(around.closestPoint(p).distance, below.closestPoint(p).distance);
      }
    }
    return gap;
  }

  /// Distances of the diaphragm's samples, kNear for those not of the parts in question.
  template <class Wanted, class Distance>
  std::vector<double> ofDiaphragm(const Wanted& wanted, const Distance& distance) const {
    const auto& part = anatomy_.diaphragm.part;
    const std::vector<Eigen::Vector3f> at = diaphragmSamples();
    std::vector<double> all(at.size(), kNear);
    for (std::size_t i = 0; i < at.size(); ++i) {
      if (holds(i, part.size(), diaphragmEdges_, [&](std::size_t k) { return wanted(part[k]); }))
        all[i] = distance(at[i].cast<double>());
    }
    return all;
  }

  std::vector<double> lifts() const {
    return ofDiaphragm(
        [](DiaphragmPart part) { return part == DiaphragmPart::Tendon || part == DiaphragmPart::Dome; },
        [left = lung(0), right = lung(1)](const Eigen::Vector3d& p) {
          return std::min(left.closestPoint(p).distance, right.closestPoint(p).distance);
        });
  }

  std::vector<double> zoneGaps() const {
    return ofDiaphragm([](DiaphragmPart part) { return part == DiaphragmPart::Wall; },
                       [walls = std::array{wall(0), wall(1)}](const Eigen::Vector3d& p) {
                         return walls[p.x() >= 0.0 ? 0 : 1].closestPoint(p).distance;
                       });
  }

  /// Which samples of the diaphragm lie over ribs or cartilages, rather than the spine or no bone at all.
  std::vector<bool> besideRibs() const {
    const std::vector<Eigen::Vector3f> at = diaphragmSamples();
    std::vector<bool> beside(at.size(), false);
    std::vector<double> nearest(at.size(), kBetweenRibs);
    for (const Bone& bone : bones_) {
      const SurfaceQuery surface(bone.mesh->points, bone.mesh->triangles);
      for (std::size_t i = 0; i < at.size(); ++i) {
        const auto found = surface.closestPointWithin(at[i].cast<double>(), nearest[i]);
        if (!found) continue;
        nearest[i] = found->distance;
        beside[i] = bone.weights.front().count > 0;
      }
    }
    return beside;
  }

  std::vector<double> diaphragmDepths() const {
    const std::vector<Eigen::Vector3f> at = diaphragmSamples();
    std::vector<double> depth(at.size(), -kNear);
    for (const Bone& bone : bones_) {
      const SurfaceQuery surface = moved(bone);
      for (std::size_t i = 0; i < depth.size(); ++i) depth[i] = std::max(depth[i], depthIn(surface, at[i]));
    }
    return depth;
  }

  void penetrate(Worst& worst) const {
    const std::array<SurfaceQuery, 2> lungs{lung(0), lung(1)};
    const SurfaceQuery sheet = diaphragm();
    for (std::size_t side = 0; side < 2; ++side) {
      for (const Eigen::Vector3f& p : diaphragmSamples())
        worst.take(depthIn(lungs[side], p), "diaphragm in lung", p);
      for (const Eigen::Vector3f& p : lungSamples(side))
        worst.take(depthUnder(sheet, p), "lung under diaphragm", p);
    }
    for (const Bone& bone : bones_) {
      const SurfaceQuery surface = moved(bone);
      for (std::size_t side = 0; side < 2; ++side) {
        for (const Eigen::Vector3f& p : lungSamples(side))
          worst.take(depthIn(surface, p), "lung in " + bone.name, p);
        for (const Eigen::Vector3f& p : surface.points())
          worst.take(depthIn(lungs[side], p), bone.name + " in lung", p);
      }
    }
  }

  const Anatomy& anatomy_;
  ThoraxMotion& motion_;
  Edges diaphragmEdges_;
  std::array<Edges, 2> lungEdges_;
  std::vector<Bone> bones_;
  std::array<std::vector<double>, 2> gapAtRest_;
  std::vector<double> zoneAtRest_;
  std::vector<bool> besideRibs_;
  std::vector<double> liftAtRest_;
  std::vector<double> depthAtRest_;
};

}  // namespace pleura
