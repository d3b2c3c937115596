#include <cmath>
#include <numbers>

#include <pleura/nodes/thorax/anatomy/diaphragm.h>
#include <pleura/nodes/thorax/anatomy/measurements.h>

namespace pleura {
namespace {

using Eigen::Vector3d;

constexpr double kMeridianStep =
    2.0 * std::numbers::pi / DiaphragmShape::kColumns;  // [rad] between meridians
constexpr int kEdgeKnot = 11;                           // s = 1

// Slope at the middle of three equally spaced values: the harmonic mean of the two slopes, none at an
// extremum.
double monotoneSlope(double before, double here, double after) {
  const double d0 = here - before;
  const double d1 = after - here;
  return d0 * d1 > 0.0 ? 2.0 * d0 * d1 / (d0 + d1) : 0.0;
}

double monotoneCubic(double p0, double p1, double p2, double p3, double t) {
  const double m1 = monotoneSlope(p0, p1, p2);
  const double m2 = monotoneSlope(p1, p2, p3);
  const double u = 1.0 - t;
  return u * u * (1.0 + 2.0 * t) * p1 + t * u * u * m1 + t * t * (3.0 - 2.0 * t) * p2 - t * t * u * m2;
}

// The four columns around an azimuth and the place between the middle two.
struct Around {
  std::array<std::size_t, 4> column;
  double t;

  explicit Around(double azimuth) {
    const double at = azimuth / kMeridianStep;
    const double floor = std::floor(at);
    t = at - floor;
    for (std::size_t k = 0; k < 4; ++k) {
      const int index = static_cast<int>(floor) + static_cast<int>(k) - 1;
      column[k] = static_cast<std::size_t>((index + 2 * DiaphragmShape::kColumns) % DiaphragmShape::kColumns);
    }
  }

  template <class Rows>
  double read(const Rows& rows, std::size_t knot) const {
    return monotoneCubic(rows[column[0]][knot], rows[column[1]][knot], rows[column[2]][knot],
                         rows[column[3]][knot], t);
  }
};

}  // namespace

DiaphragmShape::DiaphragmShape() {
  const Table table = measurementTable("diaphragm");
  axis_ = table.point(0, "");
  for (std::size_t knot = 0; knot < kKnots; ++knot) knots_.push_back(table.number(knot, "s_1"));
  for (std::size_t row = 0; row < table.rows(); ++row) {
    const Vector3d point = table.point(row, "");
    const std::size_t column = row / kKnots;
    const std::size_t knot = row % kKnots;
    radius_[column][knot] = std::hypot(point.x() - axis_.x(), point.z() - axis_.z());
    height_[column][knot] = point.y();
    if (table.text(row, "part") == "tendon") tendonEdge_[column] = knots_[knot];
  }
}

std::array<Vector3d, DiaphragmShape::kKnots> DiaphragmShape::meridian(double azimuth) const {
  const Around around(azimuth);
  std::array<Vector3d, kKnots> points;
  for (std::size_t knot = 0; knot < kKnots; ++knot) {
    const double r = around.read(radius_, knot);
    points[knot] = {axis_.x() + r * std::cos(azimuth), around.read(height_, knot),
                    axis_.z() - r * std::sin(azimuth)};
  }
  return points;
}

double DiaphragmShape::tendonEdge(double azimuth) const {
  const Around around(azimuth);
  return (1.0 - around.t) * tendonEdge_[around.column[1]] + around.t * tendonEdge_[around.column[2]];
}

double DiaphragmShape::azimuthOf(const Vector3d& point) const {
  const double azimuth = std::atan2(axis_.z() - point.z(), point.x() - axis_.x());
  return azimuth < 0.0 ? azimuth + 2.0 * std::numbers::pi : azimuth;
}

double DiaphragmShape::heightAt(const Vector3d& point) const {
  const Around around(azimuthOf(point));
  const double edge = around.read(radius_, kEdgeKnot);
  const double r = std::min(std::hypot(point.x() - axis_.x(), point.z() - axis_.z()), edge);
  const double at = r / edge * kEdgeKnot;
  const std::size_t knot = std::min(static_cast<std::size_t>(at), static_cast<std::size_t>(kEdgeKnot - 1));
  const double t = at - static_cast<double>(knot);
  return (1.0 - t) * around.read(height_, knot) + t * around.read(height_, knot + 1);
}

}  // namespace pleura
