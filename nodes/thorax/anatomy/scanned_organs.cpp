#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include <pleura/nodes/deformable/mesh/measures.h>
#include <pleura/nodes/thorax/anatomy/diaphragm.h>
#include <pleura/nodes/thorax/anatomy/lungs.h>
#include <pleura/nodes/thorax/anatomy/scanned_organs.h>

namespace pleura {
namespace {

using Eigen::Vector3d;
using Eigen::Vector3f;

constexpr int kSectors = 24;

// What bounds the dome in one sector of azimuth.
struct Sector {
  float radius = 0.0f;       // [m] of the edge in plan
  float edgeHeight = -1.0f;  // [m]
  float rimHeight = 1.0f;    // [m]
};

struct Plan {
  Vector3f axis;
  std::array<Sector, kSectors> sectors;

  explicit Plan(const std::vector<Vector3f>& points) : axis(boundingBox(points).center()) {
    axis.x() = 0.0f;
    for (const Vector3f& p : points) at(p).radius = std::max(at(p).radius, radius(p));
    for (const Vector3f& p : points) {
      at(p).rimHeight = std::min(at(p).rimHeight, p.y());
      if (radius(p) > 0.93f * at(p).radius) at(p).edgeHeight = std::max(at(p).edgeHeight, p.y());
    }
  }
  float radius(const Vector3f& p) const { return std::hypot(p.x() - axis.x(), p.z() - axis.z()); }
  float azimuth(const Vector3f& p) const {
    const float a = std::atan2(axis.z() - p.z(), p.x() - axis.x());
    return a < 0.0f ? a + 2.0f * std::numbers::pi_v<float> : a;
  }
  std::size_t sector(const Vector3f& p) const {
    return static_cast<std::size_t>(azimuth(p) / (2.0f * std::numbers::pi_v<float>)*kSectors) % kSectors;
  }
  Sector& at(const Vector3f& p) { return sectors[sector(p)]; }
  float s(const Vector3f& p) const {
    const Sector& sector = sectors[this->sector(p)];
    if (p.y() >= sector.edgeHeight) return std::min(radius(p) / std::max(sector.radius, 1e-6f), 1.0f);
    return 1.0f + (sector.edgeHeight - p.y()) / std::max(sector.edgeHeight - sector.rimHeight, 1e-6f);
  }
};

DiaphragmPart partAt(float s, const Vector3f& normal) {
  constexpr float kRim = 1.93f;
  constexpr float kTendonSlope = 0.9397f;  // cosine of 20 degrees
  if (s > kRim) return DiaphragmPart::Rim;
  if (s > 1.0f) return DiaphragmPart::Wall;
  return std::abs(normal.y()) > kTendonSlope ? DiaphragmPart::Tendon : DiaphragmPart::Dome;
}

std::vector<Vector3f> normalsOf(const TriangleMesh& mesh) {
  std::vector<Vector3f> normals(mesh.points.size());
  vertexNormals(mesh.points, mesh.triangles, normals);
  return normals;
}

Vector3d offWall(const ChestWall& wall, const Vector3d& point) {
  const double beyond = wall.beyond(point);
  return beyond > 0.0 ? Vector3d(point - beyond * (point - wall.centre()).normalized()) : point;
}

Vector3d offBones(const SurfaceQuery& bones, const Vector3d& point) {
  const SurfacePoint nearest = bones.closestPoint(point);
  const Vector3d normal = bones.pseudonormal(nearest).normalized();
  const bool inside = normal.dot(point - nearest.point) < 0.0;
  if (!inside && nearest.distance >= kPleuralGap) return point;
  return nearest.point + kPleuralGap * (inside ? normal : Vector3d((point - nearest.point).normalized()));
}

// Upwards to the gap above the highest sheet over or under the point.
Vector3d offDiaphragm(const SurfaceQuery& diaphragm, const Vector3d& point) {
  constexpr double kDeepest = 0.02;  // [m] that a scanned lung may reach into the dome
  const auto above =
      diaphragm.intersectRay(point + kDeepest * Vector3d::UnitY(), -Vector3d::UnitY(), 2.0 * kDeepest);
  if (!above) return point;
  const double steepness = std::max(std::abs(diaphragm.pseudonormal(*above).normalized().y()), 0.3);
  const double least = above->point.y() + kPleuralGap / steepness;
  return point.y() < least ? Vector3d(point.x(), least, point.z()) : point;
}

}  // namespace

Diaphragm scannedDiaphragm(TriangleMesh mesh) {
  Diaphragm diaphragm;
  const Plan plan(mesh.points);
  const std::vector<Vector3f> normals = normalsOf(mesh);
  for (std::size_t i = 0; i < mesh.points.size(); ++i) {
    diaphragm.s.push_back(plan.s(mesh.points[i]));
    diaphragm.azimuth.push_back(plan.azimuth(mesh.points[i]));
    diaphragm.part.push_back(partAt(diaphragm.s.back(), normals[i]));
  }
  diaphragm.domeTopLeft = domeTop(mesh, Side::Left);
  diaphragm.domeTopRight = domeTop(mesh, Side::Right);
  diaphragm.mesh = std::move(mesh);
  return diaphragm;
}

Lung scannedLung(TriangleMesh mesh, Side side, const ChestWall& wall, const SurfaceQuery& bones,
                 const SurfaceQuery& diaphragm) {
  constexpr double kTouching = 0.012;  // [m], a scanned lung fits less closely than a generated one
  for (Vector3f& p : mesh.points) {
    const Vector3d inside = offWall(wall, p.cast<double>());
    p = offBones(bones, offDiaphragm(diaphragm, offWall(wall, offBones(bones, inside)))).cast<float>();
  }
  Lung lung;
  lung.side = side;
  lung.name = side == Side::Left ? "LUNG_L" : "LUNG_R";
  const std::vector<Vector3f> normals = normalsOf(mesh);
  for (std::size_t i = 0; i < mesh.points.size(); ++i) {
    const Vector3d p = mesh.points[i].cast<double>();
    const bool onDiaphragm = normals[i].y() < -0.2f && diaphragm.closestPoint(p).distance < kTouching;
    const bool onWall = wall.beyond(p) > -kTouching && sign(side) * normals[i].x() > -0.5f;
    lung.part.push_back(onDiaphragm ? LungPart::Diaphragmatic
                        : onWall    ? LungPart::Costal
                                    : LungPart::Mediastinal);
  }
  lung.apex = *std::max_element(mesh.points.begin(), mesh.points.end(),
                                [](const auto& a, const auto& b) { return a.y() < b.y(); });
  lung.mesh = std::move(mesh);
  return lung;
}

}  // namespace pleura
