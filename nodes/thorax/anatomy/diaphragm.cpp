#include <pleura/nodes/deformable/mesh/surface_query.h>
#include <pleura/nodes/deformable/mesh/topology.h>
#include <pleura/nodes/thorax/anatomy/diaphragm.h>
#include <pleura/nodes/thorax/anatomy/spline.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace pleura {
namespace {

using Eigen::Vector3d;
using Eigen::Vector3f;

// Ring k has 6 k points as far as kGrowing, as many from there on: triangles stay even on dome and wall.
constexpr int kGrowing = 15;
constexpr int kRings = 30;
constexpr std::size_t kRimPoints = 6 * kGrowing;
constexpr double kTurn = 2.0 * std::numbers::pi;

int pointsOn(int ring) { return ring == 0 ? 1 : 6 * std::min(ring, kGrowing); }

// A meridian read by the fraction of its length.
struct Meridian {
  Spline spline;
  ArcLength length;

  Meridian(const DiaphragmShape& shape, double azimuth) : spline(make(shape, azimuth)), length(spline) {}
  static Spline make(const DiaphragmShape& shape, double azimuth) {
    const auto points = shape.meridian(azimuth);
    return Spline(shape.knots(), {points.begin(), points.end()});
  }
  double s(double fraction) const { return length.parameter(fraction * length.length()); }
};

// Azimuths at equal steps of the way around, that of the dome's edge and that of the rim taken together: near
// the hiatus the rim climbs steeply and would be left with few points.
class EvenAzimuths {
 public:
  explicit EvenAzimuths(const DiaphragmShape& shape) {
    auto last = shape.meridian(0.0);
    for (int k = 1; k <= kSteps; ++k) {
      const auto next = shape.meridian(kTurn * k / kSteps);
      const double edge = (next[11] - last[11]).norm();
      const double rim = (next.back() - last.back()).norm();
      way_.push_back(way_.back() + edge + rim);
      last = next;
    }
  }
  double at(double fraction) const {
    const double target = fraction * way_.back();
    const auto after = std::upper_bound(way_.begin() + 1, way_.end() - 1, target);
    const double t = (target - *(after - 1)) / (*after - *(after - 1));
    return kTurn * (static_cast<double>(after - way_.begin()) - 1.0 + t) / kSteps;
  }

 private:
  static constexpr int kSteps = 720;
  std::vector<double> way_{0.0};
};

// The sheet along its meridians, with s of every point.
struct Sheet {
  TriangleMesh mesh;
  std::vector<double> s;
};

void addPoints(const DiaphragmShape& shape, Sheet& sheet) {
  const EvenAzimuths azimuths(shape);
  for (int ring = 0; ring <= kRings; ++ring) {
    for (int k = 0; k < pointsOn(ring); ++k) {
      const Meridian meridian(shape, azimuths.at(static_cast<double>(k) / pointsOn(ring)));
      sheet.s.push_back(meridian.s(static_cast<double>(ring) / kRings));
      sheet.mesh.points.push_back(meridian.spline.at(sheet.s.back()).cast<float>());
    }
  }
}

// Sews ring to ring, always across to the neighbour that is less far around.
void addTriangles(TriangleMesh& mesh) {
  int inner = 0;
  for (int ring = 0; ring < kRings; ++ring) {
    const int n = pointsOn(ring);
    const int m = pointsOn(ring + 1);
    const int outer = inner + n;
    for (int i = 0, j = 0; i < n || j < m;) {
      const int a = inner + i % n;
      const int b = outer + j % m;
      const bool alongOuter = n == 1 || i == n || (j < m && (j + 1) * n <= (i + 1) * m);
      if (alongOuter && j == m) break;
      if (alongOuter) {
        mesh.triangles.emplace_back(a, b, outer + ++j % m);
      } else {
        mesh.triangles.emplace_back(a, b, inner + ++i % n);
      }
    }
    inner = outer;
  }
}

std::vector<Vector3f> means(const std::vector<Vector3f>& points, const Adjacency& around) {
  std::vector<Vector3f> result;
  for (int i = 0; i < around.rows(); ++i) {
    Vector3f sum = Vector3f::Zero();
    for (const int k : around[i]) sum += points[k];
    result.push_back(sum / static_cast<float>(around[i].size()));
  }
  return result;
}

// Smooths without shrinking (Taubin 1995): the meridians crowd where they start, beside the hiatus, and
// crease there.
void fair(TriangleMesh& mesh) {
  constexpr int kPasses = 6;
  const Adjacency around = neighbours(mesh.points.size(), mesh.triangles);
  const std::size_t inner = mesh.points.size() - kRimPoints;
  for (int pass = 0; pass < 2 * kPasses; ++pass) {
    const float step = pass % 2 == 0 ? 0.5f : -0.53f;
    const std::vector<Vector3f> mean = means(mesh.points, around);
    for (std::size_t i = 0; i < inner; ++i) mesh.points[i] += step * (mean[i] - mesh.points[i]);
  }
}

Vector3f nearestOnLoop(const std::vector<Vector3f>& loop, const Vector3f& point) {
  Vector3f best = loop.front();
  for (std::size_t k = 0; k < loop.size(); ++k) {
    const Vector3f axis = loop[(k + 1) % loop.size()] - loop[k];
    const float t = std::clamp((point - loop[k]).dot(axis) / axis.squaredNorm(), 0.0f, 1.0f);
    const Vector3f candidate = loop[k] + t * axis;
    if ((candidate - point).squaredNorm() < (best - point).squaredNorm()) best = candidate;
  }
  return best;
}

// Evens out the triangles: every point towards the mean of its neighbours, within the sheet, the rim's within
// the rim.
void relax(TriangleMesh& mesh) {
  constexpr int kPasses = 60;
  const SurfaceQuery sheet(mesh.points, mesh.triangles);
  const Adjacency around = neighbours(mesh.points.size(), mesh.triangles);
  const std::size_t inner = mesh.points.size() - kRimPoints;
  const std::vector<Vector3f> rim(mesh.points.begin() + static_cast<std::ptrdiff_t>(inner),
                                  mesh.points.end());
  for (int pass = 0; pass < kPasses; ++pass) {
    const std::vector<Vector3f> mean = means(mesh.points, around);
    const std::vector<Vector3f> before = mesh.points;
    for (std::size_t i = 0; i < inner; ++i) {
      mesh.points[i] = sheet.closestPoint((0.5f * (before[i] + mean[i])).cast<double>()).point.cast<float>();
    }
    for (std::size_t k = 0; k < rim.size(); ++k) {
      const Vector3f next = before[inner + (k + 1) % rim.size()];
      const Vector3f last = before[inner + (k + rim.size() - 1) % rim.size()];
      mesh.points[inner + k] = nearestOnLoop(rim, 0.5f * before[inner + k] + 0.25f * (next + last));
    }
  }
}

// The sheet runs on the inside of the cage; where the measured one and the swept ribs disagree, the ribs win.
void pressInside(TriangleMesh& mesh, const std::array<ChestWall, 2>& walls) {
  for (Vector3f& point : mesh.points) {
    const ChestWall& wall = walls[point.x() > 0.0f ? 0 : 1];
    const Vector3d ray = point.cast<double>() - wall.centre();
    const double beyond = wall.beyond(point.cast<double>());
    if (beyond > 0.0) point -= (beyond * ray.normalized()).cast<float>();
  }
}

void addTags(const DiaphragmShape& shape, const Sheet& sheet, Diaphragm& diaphragm) {
  const SurfaceQuery query(sheet.mesh.points, sheet.mesh.triangles);
  const std::size_t inner = diaphragm.mesh.points.size() - kRimPoints;
  for (std::size_t i = 0; i < diaphragm.mesh.points.size(); ++i) {
    const Vector3d point = diaphragm.mesh.points[i].cast<double>();
    const SurfacePoint at = query.closestPoint(point);
    const Eigen::Vector3i& t = sheet.mesh.triangles[at.triangle];
    const double s = at.barycentric.dot(Vector3d(sheet.s[t[0]], sheet.s[t[1]], sheet.s[t[2]]));
    const double azimuth = shape.azimuthOf(point);
    diaphragm.s.push_back(static_cast<float>(s));
    diaphragm.azimuth.push_back(static_cast<float>(azimuth));
    diaphragm.part.push_back(i >= inner                       ? DiaphragmPart::Rim
                             : s > 1.0                        ? DiaphragmPart::Wall
                             : s <= shape.tendonEdge(azimuth) ? DiaphragmPart::Tendon
                                                              : DiaphragmPart::Dome);
  }
}

Vector3f domeTop(const TriangleMesh& mesh, Side side) {
  constexpr float kBesideHeart = 0.035f;  // [m] from the midline: the saddle under the heart is no dome
  Vector3f top(0.0f, -1.0f, 0.0f);
  for (const Vector3f& point : mesh.points) {
    if (sign(side) * point.x() > kBesideHeart && point.y() > top.y()) top = point;
  }
  return top;
}

}  // namespace

Diaphragm generateDiaphragm(const DiaphragmShape& shape, const std::array<ChestWall, 2>& walls) {
  Sheet sheet;
  addPoints(shape, sheet);
  addTriangles(sheet.mesh);
  fair(sheet.mesh);
  Diaphragm diaphragm;
  diaphragm.mesh = sheet.mesh;
  relax(diaphragm.mesh);
  addTags(shape, sheet, diaphragm);
  pressInside(diaphragm.mesh, walls);
  diaphragm.domeTopLeft = domeTop(diaphragm.mesh, Side::Left);
  diaphragm.domeTopRight = domeTop(diaphragm.mesh, Side::Right);
  return diaphragm;
}

}  // namespace pleura
