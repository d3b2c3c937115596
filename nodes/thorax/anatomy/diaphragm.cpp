#include <pleura/nodes/deformable/mesh/topology.h>
#include <pleura/nodes/thorax/anatomy/diaphragm.h>
#include <pleura/nodes/thorax/anatomy/spline.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace pleura {
namespace {

using Eigen::Vector3d;

// Ring k has 6 k points as far as kGrowing, as many from there on: triangles stay even on dome and wall.
constexpr int kGrowing = 15;
constexpr int kRings = 30;
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

DiaphragmPart partAt(const DiaphragmShape& shape, int ring, double azimuth, double s) {
  if (ring == kRings) return DiaphragmPart::Rim;
  if (s > 1.0) return DiaphragmPart::Wall;
  return s <= shape.tendonEdge(azimuth) ? DiaphragmPart::Tendon : DiaphragmPart::Dome;
}

void addPoints(const DiaphragmShape& shape, Diaphragm& diaphragm) {
  const EvenAzimuths azimuths(shape);
  for (int ring = 0; ring <= kRings; ++ring) {
    for (int k = 0; k < pointsOn(ring); ++k) {
      const double azimuth = azimuths.at(static_cast<double>(k) / pointsOn(ring));
      const Meridian meridian(shape, azimuth);
      const double s = meridian.s(static_cast<double>(ring) / kRings);
      diaphragm.mesh.points.push_back(meridian.spline.at(s).cast<float>());
      diaphragm.part.push_back(partAt(shape, ring, azimuth, s));
      diaphragm.azimuth.push_back(static_cast<float>(azimuth));
      diaphragm.s.push_back(static_cast<float>(s));
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

// Smooths without shrinking (Taubin 1995): the meridians crowd where they start, beside the hiatus, and
// crease there.
void fair(TriangleMesh& mesh, const std::vector<DiaphragmPart>& part) {
  constexpr int kPasses = 6;
  const Adjacency around = neighbours(mesh.points.size(), mesh.triangles);
  for (int pass = 0; pass < 2 * kPasses; ++pass) {
    const float step = pass % 2 == 0 ? 0.5f : -0.53f;
    const std::vector<Eigen::Vector3f> before = mesh.points;
    for (std::size_t i = 0; i < before.size(); ++i) {
      if (part[i] == DiaphragmPart::Rim) continue;
      Eigen::Vector3f mean = Eigen::Vector3f::Zero();
      for (const int k : around[static_cast<int>(i)]) mean += before[k];
      mean /= static_cast<float>(around[static_cast<int>(i)].size());
      mesh.points[i] += step * (mean - before[i]);
    }
  }
}

Eigen::Vector3f domeTop(const TriangleMesh& mesh, Side side) {
  constexpr float kBesideHeart = 0.035f;  // [m] from the midline: the saddle under the heart is no dome
  Eigen::Vector3f top(0.0f, -1.0f, 0.0f);
  for (const Eigen::Vector3f& point : mesh.points) {
    if (sign(side) * point.x() > kBesideHeart && point.y() > top.y()) top = point;
  }
  return top;
}

}  // namespace

Diaphragm generateDiaphragm(const DiaphragmShape& shape) {
  Diaphragm diaphragm;
  addPoints(shape, diaphragm);
  addTriangles(diaphragm.mesh);
  fair(diaphragm.mesh, diaphragm.part);
  diaphragm.domeTopLeft = domeTop(diaphragm.mesh, Side::Left);
  diaphragm.domeTopRight = domeTop(diaphragm.mesh, Side::Right);
  return diaphragm;
}

}  // namespace pleura
