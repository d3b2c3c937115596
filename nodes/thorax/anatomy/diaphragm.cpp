#include <algorithm>
#include <cmath>
#include <numbers>

#include <pleura/nodes/deformable/mesh/measures.h>
#include <pleura/nodes/deformable/mesh/surface_query.h>
#include <pleura/nodes/deformable/mesh/topology.h>
#include <pleura/nodes/thorax/anatomy/diaphragm.h>
#include <pleura/nodes/thorax/anatomy/implicit_surface.h>
#include <pleura/nodes/thorax/anatomy/measurements.h>
#include <pleura/nodes/thorax/anatomy/open_sheet.h>
#include <pleura/nodes/thorax/anatomy/smooth_field.h>

namespace pleura {
namespace {

using Eigen::Vector3d;
using Eigen::Vector3f;

constexpr int kMeridians = 96;
constexpr int kRows = DiaphragmShape::kKnots;  // knots s > 0, and the skirt's end
constexpr double kDiaphragmSpacing = 0.0082;   // [m] triangle size
constexpr double kDiaphragmBlur = 0.006;  // [m] against creases where the meridians meet beside the hiatus
constexpr double kDiaphragmSeam = 0.003;  // [m] over which the sheet turns along the chest wall
constexpr double kFarFromSheet = 0.015;   // [m] from the sheet, where the walls make no difference
constexpr double kRim = 2.0;              // s

// The measured sheet made a solid: its wall goes on below the rim as a skirt, and a cone closes it.
struct Abdomen {
  TriangleMesh mesh;
  std::vector<double> s;      // of every point; more than 2 below the rim
  std::vector<Vector3f> rim;  // closed polyline
};

Abdomen measuredAbdomen(const DiaphragmShape& shape) {
  constexpr double kSkirt = 0.02;  // [m]
  Abdomen abdomen;
  auto& points = abdomen.mesh.points;
  std::vector<std::array<Vector3d, DiaphragmShape::kKnots>> meridians;
  meridians.reserve(kMeridians);
  for (int k = 0; k < kMeridians; ++k)
    meridians.push_back(shape.meridian(2.0 * std::numbers::pi * k / kMeridians));
  points.push_back(meridians.front().front().cast<float>());
  abdomen.s.push_back(0.0);
  for (int row = 1; row < DiaphragmShape::kKnots; ++row) {
    for (const auto& meridian : meridians) points.push_back(meridian[row].cast<float>());
    abdomen.s.insert(abdomen.s.end(), kMeridians, shape.knots()[row]);
  }
  abdomen.rim.assign(points.end() - kMeridians, points.end());
  for (const auto& meridian : meridians) {
    const Vector3d downwards = (meridian.back() - meridian.end()[-2]).normalized();
    points.push_back((meridian.back() + kSkirt * downwards).cast<float>());
  }
  abdomen.s.insert(abdomen.s.end(), kMeridians, kRim + 1.0);
  const int tip = static_cast<int>(points.size());
  points.push_back(fromTableFrame({0.0, -120.0, 1080.0}).cast<float>());
  abdomen.s.push_back(kRim + 2.0);

  const auto index = [&](int row, int k) { return 1 + row * kMeridians + k % kMeridians; };
  for (int k = 0; k < kMeridians; ++k) {
    abdomen.mesh.triangles.emplace_back(0, index(0, k), index(0, k + 1));
    for (int row = 0; row + 1 < kRows; ++row) {
      abdomen.mesh.triangles.emplace_back(index(row, k), index(row + 1, k), index(row + 1, k + 1));
      abdomen.mesh.triangles.emplace_back(index(row, k), index(row + 1, k + 1), index(row, k + 1));
    }
    abdomen.mesh.triangles.emplace_back(index(kRows - 1, k), tip, index(kRows - 1, k + 1));
  }
  return abdomen;
}

double sAt(const Abdomen& abdomen, const SurfaceQuery& query, const Vector3d& point) {
  const SurfacePoint at = query.closestPoint(point);
  const Eigen::Vector3i& t = abdomen.mesh.triangles[at.triangle];
  return at.barycentric.dot(Vector3d(abdomen.s[t[0]], abdomen.s[t[1]], abdomen.s[t[2]]));
}

// The walls of both sides; in the midline, where neither has bones, they open.
double beyondWalls(const std::array<ChestWall, 2>& walls, const Vector3d& point) {
  constexpr double kMidline = 0.016;  // [m]
  constexpr double kOpening = 0.05;   // [m]
  const double opening = kOpening * std::max(0.0, 1.0 - std::abs(point.x()) / kMidline);
  return walls[point.x() > 0.0 ? 0 : 1].beyond(point) - opening;
}

// Draws the ragged border of the cut to the rim and spreads the triangles behind it.
void drawToRim(OpenSheet& sheet, const std::vector<Vector3f>& rim, const Solid& solid) {
  constexpr int kPasses = 30;
  const Adjacency around = neighbours(sheet.mesh.points.size(), sheet.mesh.triangles);
  std::vector<int> last(sheet.next.size(), -1);
  for (std::size_t i = 0; i < last.size(); ++i) {
    if (sheet.next[i] >= 0) last[sheet.next[i]] = static_cast<int>(i);
  }
  for (int pass = 0; pass < kPasses; ++pass) {
    const std::vector<Vector3f> before = sheet.mesh.points;
    for (int i = 0; i < around.rows(); ++i) {
      if (sheet.next[i] >= 0) {
        const Vector3f along = 0.25f * (before[sheet.next[i]] + before[last[i]]);
        sheet.mesh.points[i] = nearestOnLoop(rim, 0.5f * before[i] + along);
        continue;
      }
      Vector3f mean = Vector3f::Zero();
      for (const int k : around[i]) mean += before[k];
      mean /= static_cast<float>(around[i].size());
      sheet.mesh.points[i] =
          nearestOnSkin(solid, (0.5f * (before[i] + mean)).cast<double>(), kDiaphragmSpacing).cast<float>();
    }
  }
}

void addTags(const DiaphragmShape& shape, const std::vector<int>& next, const Abdomen& abdomen,
             const SurfaceQuery& query, Diaphragm& diaphragm) {
  for (std::size_t i = 0; i < diaphragm.mesh.points.size(); ++i) {
    const Vector3d point = diaphragm.mesh.points[i].cast<double>();
    const double s = next[i] >= 0 ? kRim : std::min(sAt(abdomen, query, point), kRim);
    const double azimuth = shape.azimuthOf(point);
    diaphragm.s.push_back(static_cast<float>(s));
    diaphragm.azimuth.push_back(static_cast<float>(azimuth));
    DiaphragmPart part = DiaphragmPart::Dome;
    if (s > 1.0) part = DiaphragmPart::Wall;
    if (s <= shape.tendonEdge(azimuth)) part = DiaphragmPart::Tendon;
    if (next[i] >= 0) part = DiaphragmPart::Rim;
    diaphragm.part.push_back(part);
  }
}

}  // namespace

Vector3f pressedInside(const std::array<ChestWall, 2>& walls, const Vector3f& point) {
  const Vector3d ray = point.cast<double>() - walls[point.x() > 0.0f ? 0 : 1].centre();
  const double beyond = beyondWalls(walls, point.cast<double>());
  return beyond > 0.0 ? Vector3f(point - (beyond * ray.normalized()).cast<float>()) : point;
}

Vector3f domeTop(const TriangleMesh& mesh, Side side) {
  constexpr float kBesideHeart = 0.035f;  // [m] from the midline: the saddle under the heart is no dome
  Vector3f top(0.0f, -1.0f, 0.0f);
  for (const Vector3f& point : mesh.points) {
    if (sign(side) * point.x() > kBesideHeart && point.y() > top.y()) top = point;
  }
  return top;
}

Diaphragm generateDiaphragm(const DiaphragmShape& shape, const std::array<ChestWall, 2>& walls) {
  Abdomen abdomen = measuredAbdomen(shape);
  const SurfaceQuery measured(abdomen.mesh.points, abdomen.mesh.triangles);
  const Vector3f margin = Vector3f::Constant(0.02f);
  Eigen::AlignedBox3f box = boundingBox(abdomen.mesh.points);
  box = {box.min() - margin, box.max() + margin};
  const SmoothField blurred([&](const Vector3d& p) { return measured.signedDistance(p); }, box.cast<double>(),
                            kDiaphragmBlur);
  const Solid solid = [&](const Vector3d& p) {
    const double sheet = blurred(p);
    return std::abs(sheet) > kFarFromSheet ? sheet
                                           : smoothIntersection(sheet, beyondWalls(walls, p), kDiaphragmSeam);
  };

  const TriangleMesh closed = skinOf(solid, box.cast<double>(), kDiaphragmSpacing);
  std::vector<bool> keep;
  for (const Vector3f& point : closed.points)
    keep.push_back(sAt(abdomen, measured, point.cast<double>()) <= kRim);
  OpenSheet sheet = cutOpen(closed, keep);
  for (Vector3f& point : abdomen.rim) point = pressedInside(walls, point);
  drawToRim(sheet, abdomen.rim, solid);

  Diaphragm diaphragm;
  diaphragm.mesh = std::move(sheet.mesh);
  addTags(shape, sheet.next, abdomen, measured, diaphragm);
  diaphragm.domeTopLeft = domeTop(diaphragm.mesh, Side::Left);
  diaphragm.domeTopRight = domeTop(diaphragm.mesh, Side::Right);
  return diaphragm;
}

}  // namespace pleura
