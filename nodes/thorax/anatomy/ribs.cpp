#include <cmath>

#include <Eigen/Geometry>
#include <fmt/format.h>

#include <pleura/nodes/deformable/mesh/nearest_point.h>
#include <pleura/nodes/thorax/anatomy/inner_line.h>
#include <pleura/nodes/thorax/anatomy/measurements.h>
#include <pleura/nodes/thorax/anatomy/ribs.h>
#include <pleura/nodes/thorax/anatomy/tube.h>

namespace pleura {
namespace {

using Eigen::Vector3d;

constexpr int kRings = 38;
constexpr int kRibSectors = 12;
constexpr int kStations = 16;

// Where the end face is oblique (rib 1), the last centre lies aside and would fold the tube: go on straight
// instead.
void straightenEnd(std::vector<TubeStation>& stations) {
  constexpr double kFoldingCosine = 0.7;
  Vector3d& end = stations.back().centre;
  const Vector3d& before = stations.end()[-2].centre;
  const Vector3d forwards = (before - stations.end()[-3].centre).normalized();
  const Vector3d last = end - before;
  if (forwards.dot(last) < kFoldingCosine * last.norm()) end = before + last.norm() * forwards;
}

Tube ribTube(const Table& stations, std::size_t firstRow) {
  std::vector<TubeStation> tube(kStations);
  for (std::size_t k = 0; k < tube.size(); ++k) {
    const std::size_t row = firstRow + k;
    tube[k] = {stations.number(row, "fraction_1"), stations.point(row, ""),
               1e-3 * stations.number(row, "half_major_mm"), 1e-3 * stations.number(row, "half_minor_mm"),
               stations.direction(row, "major_")};
  }
  straightenEnd(tube);
  return Tube(std::move(tube));
}

// The swept ellipse is too smooth at the tubercle: raise its skin there, as a bell of the tubercle's own
// width, until it passes through the measured point.
void raiseTubercle(TriangleMesh& mesh, const Eigen::Vector3f& tubercle) {
  constexpr float kWidth = 0.006f;  // [m]
  const Eigen::Vector3f foot = mesh.points[nearestPoint(mesh.points, tubercle)];
  const Eigen::Vector3f rise = tubercle - foot;
  for (Eigen::Vector3f& point : mesh.points) {
    point += std::exp(-(point - foot).squaredNorm() / (kWidth * kWidth)) * rise;
  }
}

Rib makeRib(const Table& stations, const Table& summary, std::size_t row) {
  Rib rib;
  rib.side = summary.text(row, "side") == "left" ? Side::Left : Side::Right;
  rib.number = summary.integer(row, "rib");
  rib.name = fmt::format("RIB_{}{}", rib.side == Side::Left ? 'L' : 'R', rib.number);
  const Tube tube = ribTube(stations, row * kStations);
  rib.mesh = tubeMesh(tube, kRings, kRibSectors);
  rib.head = summary.point(row, "head_").cast<float>();
  rib.tubercle = summary.point(row, "tubercle_").cast<float>();
  rib.neckAxis = summary.direction(row, "axis_").cast<float>();
  for (const Vector3d& point : tube.centreline(kRibSamples)) rib.centreline.push_back(point.cast<float>());
  rib.sternalEnd = rib.centreline.back();
  rib.innerLine = innerLine(tube, rib.side, kRibSamples);
  raiseTubercle(rib.mesh, rib.tubercle);
  return rib;
}

}  // namespace

std::vector<Rib> generateRibs() {
  const Table stations = measurementTable("ribs");
  const Table summary = measurementTable("ribs_summary");
  std::vector<Rib> ribs;
  for (std::size_t row = 0; row < summary.rows(); ++row) ribs.push_back(makeRib(stations, summary, row));
  std::stable_partition(ribs.begin(), ribs.end(), [](const Rib& rib) { return rib.side == Side::Left; });
  return ribs;
}

}  // namespace pleura
