#include <stdexcept>

#include <pleura/nodes/thorax/motion/hemithorax.h>

namespace pleura {
namespace {

constexpr double kCupolaAboveApex = 0.004;  // [m]
constexpr float kFoldLevel = 1.0f;          // of Diaphragm::s
constexpr float kRimLevel = 1.99f;

std::vector<WallBody> bodiesOf(const Anatomy& anatomy, const CageMotion& cage, Side side) {
  std::vector<WallBody> bodies;
  const auto rigid = [](const TriangleMesh& mesh, const BodyWeights& weights) {
    return WallBody{&mesh, std::vector<BodyWeights>(mesh.points.size(), weights)};
  };
  for (const Rib& part : anatomy.ribs) {
    if (part.side == side) bodies.push_back(rigid(part.mesh, rigidWith(ribBody(side, part.number))));
  }
  for (std::size_t k = 0; k < anatomy.cartilages.size(); ++k) {
    if (anatomy.cartilages[k].side == side) {
      bodies.push_back({&anatomy.cartilages[k].mesh, cage.cartilageWeights(k)});
    }
  }
  bodies.push_back(rigid(anatomy.sternum.mesh, rigidWith(kSternum)));
  for (const Vertebra& part : anatomy.vertebrae) {
    bodies.push_back(rigid(part.bone, {}));
    bodies.push_back(rigid(part.disc, {}));
  }
  return bodies;
}

/// Sum and number of points, for means over several lists.
struct Mean {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  int count = 0;

  void add(const Eigen::Vector3f& p) {
    sum += p.cast<double>();
    ++count;
  }
  Eigen::Vector3d value() const { return sum / count; }
};

/// Where the edges of one side of the diaphragm cross a level of s.
std::vector<Eigen::Vector3d> ring(const Diaphragm& diaphragm, Side side, float level) {
  std::vector<Eigen::Vector3d> points;
  for (const Eigen::Vector3i& triangle : diaphragm.mesh.triangles) {
    for (int k = 0; k < 3; ++k) {
      const auto i = static_cast<std::size_t>(triangle[k]);
      const auto j = static_cast<std::size_t>(triangle[(k + 1) % 3]);
      if (!(diaphragm.s[i] <= level && level < diaphragm.s[j])) continue;
      const float t = (level - diaphragm.s[i]) / (diaphragm.s[j] - diaphragm.s[i]);
      const Eigen::Vector3f p = (1.0f - t) * diaphragm.mesh.points[i] + t * diaphragm.mesh.points[j];
      if (p.x() * sign(side) >= 0.0f) points.push_back(p.cast<double>());
    }
  }
  return points;
}

const Lung& lungOf(const Anatomy& anatomy, Side side) {
  for (const Lung& lung : anatomy.lungs) {
    if (lung.side == side) return lung;
  }
  throw std::invalid_argument("buildHemithorax: the anatomy lacks a lung");
}

}  // namespace

HemithoraxEnds hemithoraxEnds(const Anatomy& anatomy, Side side) {
  Mean high;
  for (const Eigen::Vector3f& p : rib(anatomy, side, 1).centreline) high.add(p);
  for (const Eigen::Vector3f& p : cartilage(anatomy, side, 1).centreline) high.add(p);
  Mean low;
  for (std::size_t i = 0; i < anatomy.diaphragm.part.size(); ++i) {
    const Eigen::Vector3f& p = anatomy.diaphragm.mesh.points[i];
    if (p.x() * sign(side) > 0.0f && anatomy.diaphragm.part[i] == DiaphragmPart::Rim) low.add(p);
  }
  if (low.count == 0) throw std::invalid_argument("hemithoraxEnds: the diaphragm has no rim on a side");
  const Eigen::Vector3d apex = lungOf(anatomy, side).apex.cast<double>();
  const Eigen::Vector3d top = 0.5 * (high.value() + apex);
  const double height = hemithoraxAxis(low.value(), top, sign(side)).coordinates(apex).height;
  return {low.value(), top, height + kCupolaAboveApex};
}

WallSlide slideOf(const PleuralWall& wall, const Diaphragm& diaphragm, Side side, double foldDrop) {
  return slideOnWall(wall, ring(diaphragm, side, kFoldLevel), ring(diaphragm, side, kRimLevel), foldDrop);
}

Hemithorax buildHemithorax(const Anatomy& anatomy, const CageMotion& cage, Side side, double foldDrop) {
  const HemithoraxEnds ends = hemithoraxEnds(anatomy, side);
  const HemithoraxAxis axis = hemithoraxAxis(ends.low, ends.high, sign(side));
  Hemithorax half;
  half.wall = buildPleuralWall(axis, bodiesOf(anatomy, cage, side), ends.cupola);
  half.slide = slideOf(half.wall, anatomy.diaphragm, side, foldDrop);
  return half;
}

void displaceFollowers(const Hemithorax& half, std::span<const Eigen::Vector4f> wallNow,
                       std::span<const WallFollower> followers, double contraction,
                       std::span<Eigen::Vector4f> displacement) {
  for (const WallFollower& f : followers) {
    displacement[static_cast<std::size_t>(f.index)] =
        followWall(half.wall, wallNow, half.slide, f.place, contraction) - f.place.rest;
  }
}

}  // namespace pleura
