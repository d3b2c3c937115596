#include <algorithm>
#include <cmath>

#include <pleura/nodes/deformable/mesh/measures.h>
#include <pleura/nodes/thorax/anatomy/bones.h>
#include <pleura/nodes/thorax/anatomy/chest_wall.h>
#include <pleura/nodes/thorax/anatomy/implicit_surface.h>
#include <pleura/nodes/thorax/anatomy/lung_sections.h>
#include <pleura/nodes/thorax/anatomy/lungs.h>
#include <pleura/nodes/thorax/anatomy/smooth_field.h>

namespace pleura {
namespace {

using Eigen::Vector3d;

constexpr double kLungSpacing = 0.0052;  // [m] triangle size
constexpr double kSectionBlur = 0.013;   // [m] the measured sections' distance
constexpr double kLungBlur = 0.006;      // [m] rounding of borders and edges
constexpr double kLungSeam = 0.002;      // [m] over which the skin turns onto a bone
constexpr double kGrowth = 0.012;        // [m] the fit's largest gap to the wall, which is to be filled
constexpr double kMidline = 0.004;       // [m] kept free on either side of x = 0
constexpr double kReach = 0.010;         // [m] beyond which bones need not be looked at

Eigen::AlignedBox3d boxOf(Side side) {
  const double outer = sign(side) * 0.14;
  return {Vector3d(std::min(0.0, outer), -0.09, -0.1), Vector3d(std::max(0.0, outer), 0.19, 0.11)};
}

// What bounds one lung; each function is negative on the lung's side [m].
class Space {
 public:
  Space(const LungOutline& outline, const ChestWall& wall, const DomeHeight& height)
      : side_(outline.side),
        wall_(wall),
        height_(height),
        outline_(outline.distance, outline.box, outline.blur) {}

  double beyondWall(const Vector3d& p) const { return wall_.beyond(p); }

  // Height above the dome, made a distance by the dome's slope.
  double belowDome(const Vector3d& p) const {
    constexpr double kSlopeStep = 0.002;  // [m]
    const double height = height_(p);
    const double dx = (height_(p + Vector3d(kSlopeStep, 0, 0)) - height) / kSlopeStep;
    const double dz = (height_(p + Vector3d(0, 0, kSlopeStep)) - height) / kSlopeStep;
    return kPleuralGap + (height - p.y()) / std::sqrt(1.0 + dx * dx + dz * dz);
  }

  // The measured outline, grown where wall or dome are near, but neither towards the midline nor out of the
  // inlet.
  double beyondOutline(const Vector3d& p, double wall, double dome) const {
    const double depth = -std::max(wall, dome);
    const double near = std::clamp(1.0 - depth / (2.0 * kGrowth), 0.0, 1.0);
    const double lateral = std::clamp((sign(side_) * p.x() - 0.015) / 0.03, 0.0, 1.0);
    const double belowInlet = std::clamp((0.14 - p.y()) / 0.03, 0.0, 1.0);
    return outline_(p) - kGrowth * near * near * lateral * belowInlet;
  }

  double operator()(const Vector3d& p) const {
    constexpr double kOutside = 0.03;  // [m] outside, where nothing else matters
    const double outline = outline_(p);
    if (outline > kOutside) return outline;
    const double wall = beyondWall(p);
    const double dome = belowDome(p);
    const double midline = kMidline - sign(side_) * p.x();
    return std::max({wall, dome, midline, beyondOutline(p, wall, dome)});
  }

  // Faces not at the wall are still costal where they look away from the midline, as in the inlet.
  LungPart partAt(const Vector3d& p, const Vector3d& normal) const {
    constexpr double kTouching = 0.004;  // [m]
    const double wall = beyondWall(p);
    const double dome = belowDome(p);
    if (dome > wall && dome > -kTouching) return LungPart::Diaphragmatic;
    const bool looksOut = sign(side_) * normal.x() > -0.3 && wall > -4.0 * kTouching;
    return wall > -kTouching || looksOut ? LungPart::Costal : LungPart::Mediastinal;
  }

 private:
  Side side_;
  const ChestWall& wall_;
  const DomeHeight& height_;
  SmoothField outline_;
};

double tooNear(const SurfaceQuery& surface, const Vector3d& p) {
  const auto nearest = surface.closestPointWithin(p, kReach);
  return kPleuralGap - (nearest ? nearest->distance : kReach);
}

LungOutline measuredOutline(Side side) {
  return {side, [sections = LungSections(side)](const Vector3d& p) { return sections.distance(p); },
          boxOf(side), kSectionBlur};
}

}  // namespace

Lung fillLung(const LungOutline& outline, const ChestWall& wall, const DomeHeight& height,
              const SurfaceQuery& bones, const SurfaceQuery& diaphragm) {
  const Space space(outline, wall, height);
  const SmoothField smooth([&](const Vector3d& p) { return space(p); }, outline.box, kLungBlur);
  const Solid solid = [&](const Vector3d& p) {
    const double lung = smooth(p);
    if (lung > kReach) return lung;
    return smoothIntersection(lung, std::max(tooNear(bones, p), tooNear(diaphragm, p)), kLungSeam);
  };
  Lung lung;
  lung.side = outline.side;
  lung.name = outline.side == Side::Left ? "LUNG_L" : "LUNG_R";
  lung.mesh = skinOf(solid, outline.box, kLungSpacing);
  std::vector<Eigen::Vector3f> normals(lung.mesh.points.size());
  vertexNormals(lung.mesh.points, lung.mesh.triangles, normals);
  for (std::size_t i = 0; i < normals.size(); ++i) {
    lung.part.push_back(space.partAt(lung.mesh.points[i].cast<double>(), normals[i].cast<double>()));
  }
  lung.apex = *std::max_element(lung.mesh.points.begin(), lung.mesh.points.end(),
                                [](const auto& a, const auto& b) { return a.y() < b.y(); });
  return lung;
}

std::vector<Lung> generateLungs(const Anatomy& rest, const std::array<ChestWall, 2>& walls,
                                const DiaphragmShape& shape) {
  const SurfaceQuery bones = bonesOf(rest);
  const SurfaceQuery diaphragm(rest.diaphragm.mesh.points, rest.diaphragm.mesh.triangles);
  const DomeHeight height = [&](const Vector3d& p) { return shape.heightAt(p); };
  return {fillLung(measuredOutline(Side::Left), walls[0], height, bones, diaphragm),
          fillLung(measuredOutline(Side::Right), walls[1], height, bones, diaphragm)};
}

}  // namespace pleura
