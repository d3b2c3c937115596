#include <string_view>

#include <fmt/format.h>

#include <pleura/nodes/deformable/mesh/nearest_point.h>
#include <pleura/nodes/thorax/anatomy/cartilages.h>
#include <pleura/nodes/thorax/anatomy/inner_line.h>
#include <pleura/nodes/thorax/anatomy/measurements.h>
#include <pleura/nodes/thorax/anatomy/tube.h>

namespace pleura {
namespace {

using Eigen::Vector3d;
using Eigen::Vector3f;

constexpr int kStations = 6;
constexpr int kRings = 20;
constexpr int kCartilageSectors = 12;
constexpr int kLastTrueRib = 7;

std::vector<TubeStation> measuredStations(const Table& table, std::size_t firstRow) {
  std::vector<TubeStation> stations;
  for (std::size_t row = firstRow; row < firstRow + kStations; ++row) {
    stations.push_back({0.0, table.point(row, ""), 1e-3 * table.number(row, "half_major_mm"),
                        1e-3 * table.number(row, "half_minor_mm"), table.direction(row, "major_")});
  }
  return stations;
}

// The measured start lies on the oblique end face of the rib, up to 11 mm from the last centre of its
// centreline: begin inside the bone instead, narrow enough not to come out of its sides.
void growIntoRib(std::vector<TubeStation>& stations, const Rib& rib) {
  const std::size_t nearest = nearestPoint(rib.centreline, stations.front().centre.cast<float>());
  TubeStation inside = stations.front();
  inside.centre = rib.centreline[std::min<std::size_t>(nearest, kRibSamples - 2) - 1].cast<double>();
  constexpr double kNarrow = 0.55;
  inside.halfMajor *= kNarrow;
  inside.halfMinor *= kNarrow;
  stations.insert(stations.begin(), inside);
}

// A suggested path stops beside the cartilage above: let it end on that one's centreline.
void growIntoCartilage(std::vector<TubeStation>& stations, const Cartilage& above) {
  Vector3d& end = stations.back().centre;
  end = above.centreline[nearestPoint(above.centreline, end.cast<float>())].cast<double>();
}

void setFractions(std::vector<TubeStation>& stations) {
  for (std::size_t k = 1; k < stations.size(); ++k) {
    stations[k].fraction = stations[k - 1].fraction + (stations[k].centre - stations[k - 1].centre).norm();
  }
}

Cartilage makeCartilage(const Table& table, std::size_t row, const std::vector<Rib>& ribs,
                        const std::vector<Cartilage>& before) {
  Cartilage cartilage;
  cartilage.side = table.text(row, "side") == "left" ? Side::Left : Side::Right;
  cartilage.number = table.integer(row, "cartilage");
  cartilage.joins = cartilage.number <= kLastTrueRib ? 0 : cartilage.number - 1;
  cartilage.name = fmt::format("CARTILAGE_{}{}", cartilage.side == Side::Left ? 'L' : 'R', cartilage.number);
  std::vector<TubeStation> stations = measuredStations(table, row);
  growIntoRib(stations, partOf(ribs, cartilage.side, cartilage.number));
  if (cartilage.joins > 0) growIntoCartilage(stations, partOf(before, cartilage.side, cartilage.joins));
  setFractions(stations);

  const Tube tube(std::move(stations));
  cartilage.mesh = tubeMesh(tube, kRings, kCartilageSectors);
  for (const Vector3d& point : tube.centreline(kCartilageSamples))
    cartilage.centreline.push_back(point.cast<float>());
  cartilage.innerLine = innerLine(tube, cartilage.side, kCartilageSamples);
  cartilage.start = cartilage.centreline.front();
  cartilage.end = cartilage.centreline.back();
  return cartilage;
}

}  // namespace

std::vector<Cartilage> generateCartilages(const std::vector<Rib>& ribs) {
  const Table table = measurementTable("cartilages");
  std::vector<Cartilage> cartilages;
  for (std::size_t row = 0; row < table.rows(); row += kStations) {
    cartilages.push_back(makeCartilage(table, row, ribs, cartilages));
  }
  std::stable_partition(cartilages.begin(), cartilages.end(),
                        [](const Cartilage& c) { return c.side == Side::Left; });
  return cartilages;
}

}  // namespace pleura
