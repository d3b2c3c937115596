#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include <pleura/nodes/deformable/mesh/measures.h>
#include <pleura/nodes/deformable/mesh/refinement.h>
#include <pleura/nodes/thorax/anatomy/bone_lines.h>
#include <pleura/nodes/thorax/anatomy/diaphragm.h>
#include <pleura/nodes/thorax/anatomy/lungs.h>
#include <pleura/nodes/thorax/anatomy/open_sheet.h>
#include <pleura/nodes/thorax/anatomy/scanned_organs.h>

namespace pleura {
namespace {

using Eigen::Vector3d;
using Eigen::Vector3f;

constexpr int kScanSectors = 24;

// What bounds the dome in one sector of azimuth.
struct Sector {
  float radius = 0.0f;       // [m] of the edge in plan
  float edgeHeight = -1.0f;  // [m]
  float rimHeight = 1.0f;    // [m]
};

struct Plan {
  Vector3f axis;
  std::array<Sector, kScanSectors> sectors;

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
    return static_cast<std::size_t>(azimuth(p) / (2.0f * std::numbers::pi_v<float>)*kScanSectors) %
           kScanSectors;
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

// The sheet itself, or the face of a slab that looks away from the middle of the abdomen: that towards lungs
// and ribs.
TriangleMesh thoracicFace(TriangleMesh mesh) {
  const Vector3f middle = boundingBox(mesh.points).center();
  for (Vector3f& p : mesh.points) p -= middle;
  if (signedVolume(mesh.points, mesh.triangles) < 0.0) {
    for (Eigen::Vector3i& t : mesh.triangles) std::swap(t[1], t[2]);
  }
  const std::vector<Vector3f> normals = normalsOf(mesh);
  std::vector<bool> keep;
  for (std::size_t i = 0; i < normals.size(); ++i) keep.push_back(normals[i].dot(mesh.points[i]) > 0.0f);
  TriangleMesh face = largestPiece(cutOpen(mesh, keep).mesh);
  for (Vector3f& p : face.points) p += middle;
  return face;
}

// Fine enough to bend, and no finer than breathing in real time allows.
TriangleMesh ofMovableSize(const TriangleMesh& mesh) {
  constexpr std::size_t kCoarse = 3000;
  constexpr int kMost = 8000;
  return mesh.triangles.size() < kCoarse ? subdivide(mesh) : decimate(mesh, kMost);
}

// Shorter edges where the wall carries it, so that they follow the ribs passing behind them.
TriangleMesh finerOnWalls(const TriangleMesh& mesh, const std::array<ChestWall, 2>& walls) {
  constexpr float kLongest = 0.012f;  // [m]
  constexpr double kOnWall = 0.004;   // [m]
  return splitLongEdges(mesh, kLongest, [&](const Vector3f& p) {
    return walls[p.x() >= 0.0f ? 0 : 1].beyond(p.cast<double>()) > -kOnWall;
  });
}

Vector3d offBones(const SurfaceQuery& bones, const Vector3d& point) {
  const SurfacePoint nearest = bones.closestPoint(point);
  const Vector3d normal = bones.pseudonormal(nearest).normalized();
  const bool inside = normal.dot(point - nearest.point) < 0.0;
  if (!inside && nearest.distance >= kPleuralGap) return point;
  return nearest.point + kPleuralGap * (inside ? normal : Vector3d((point - nearest.point).normalized()));
}

// The highest sheet above or below a point; beside the diaphragm the height of its nearest place.
double domeHeight(const SurfaceQuery& diaphragm, const Vector3d& point) {
  constexpr double kAbove = 0.1;  // [m] in the subject's frame
  const Vector3d high(point.x(), kAbove, point.z());
  const auto below = diaphragm.intersectRay(high, -Vector3d::UnitY());
  return (below ? below->point : diaphragm.closestPoint(high).point).y();
}

}  // namespace

Diaphragm scannedDiaphragm(TriangleMesh mesh, const std::array<ChestWall, 2>& walls,
                           const SurfaceQuery& bones) {
  Diaphragm diaphragm;
  mesh = finerOnWalls(ofMovableSize(thoracicFace(std::move(mesh))), walls);
  for (Vector3f& p : mesh.points) {
    const Vector3f inside = pressedInside(walls, p);
    p = offBones(bones, inside.cast<double>()).cast<float>();
  }
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

Lung scannedLung(const TriangleMesh& mesh, Side side, const ChestWall& wall, const SurfaceQuery& bones,
                 const SurfaceQuery& diaphragm) {
  constexpr double kScanBlur = 0.006;  // [m] triangles of a scan
  constexpr double kMargin = 0.02;     // [m] for growing
  const SurfaceQuery scan(mesh.points, mesh.triangles);
  const Eigen::AlignedBox3d box = boundingBox(mesh.points).cast<double>();
  const Vector3d margin = Vector3d::Constant(kMargin);
  return fillLung(
      {side,
       [&](const Vector3d& p) { return scan.signedDistance(p); },
       {box.min() - margin, box.max() + margin},
       kScanBlur},
      wall, [&](const Vector3d& p) { return domeHeight(diaphragm, p); }, bones, diaphragm);
}

}  // namespace pleura
