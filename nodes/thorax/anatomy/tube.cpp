#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include <Eigen/Dense>

#include <pleura/nodes/thorax/anatomy/tube.h>

namespace pleura {
namespace {

constexpr int kCapRings = 3;

using Eigen::Vector3d;

Spline splineOf(const std::vector<TubeStation>& stations) {
  std::vector<double> fractions;
  std::vector<Vector3d> centres;
  for (const TubeStation& station : stations) {
    fractions.push_back(station.fraction);
    centres.push_back(station.centre);
  }
  return Spline(std::move(fractions), std::move(centres));
}

// Axes have no sign of their own: give each the sign of the one before it.
std::vector<TubeStation> alignMajors(std::vector<TubeStation> stations) {
  for (std::size_t i = 1; i < stations.size(); ++i) {
    if (stations[i].major.dot(stations[i - 1].major) < 0.0) stations[i].major *= -1.0;
  }
  return stations;
}

// Arc lengths of the rings between the two poles; the caps are quarter turns of the given depths.
struct Ring {
  double arcLength;
  double scale;
};

std::vector<Ring> ringsOf(const Tube& tube, int rings) {
  const double length = tube.length();
  const auto depth = [&](double at) { return std::min(0.8 * tube.at(at).halfMinor, 0.25 * length); };
  const double front = depth(0.0);
  const double back = depth(length);
  std::vector<Ring> result;
  for (int k = 1; k <= kCapRings; ++k) {
    const double angle = k * std::numbers::pi / (2.0 * (kCapRings + 1));
    result.push_back({front * (1.0 - std::cos(angle)), std::sin(angle)});
  }
  for (int k = 0; k < rings; ++k) {
    result.push_back({front + (length - front - back) * k / (rings - 1), 1.0});
  }
  for (int k = kCapRings; k >= 1; --k) {
    const double angle = k * std::numbers::pi / (2.0 * (kCapRings + 1));
    result.push_back({length - back * (1.0 - std::cos(angle)), std::sin(angle)});
  }
  return result;
}

}  // namespace

Vector3d TubeSection::pointAt(double angle) const {
  return centre + halfMajor * std::cos(angle) * major + halfMinor * std::sin(angle) * minor;
}

// Support of an ellipse: (a^2 (d.M) M + b^2 (d.m) m) / sqrt(a^2 (d.M)^2 + b^2 (d.m)^2).
Vector3d TubeSection::supportPoint(const Vector3d& direction) const {
  const double a = halfMajor * direction.dot(major);
  const double b = halfMinor * direction.dot(minor);
  return centre + (halfMajor * a * major + halfMinor * b * minor) / std::hypot(a, b);
}

Tube::Tube(std::vector<TubeStation> stations)
    : stations_(alignMajors(std::move(stations))), centres_(splineOf(stations_)), arcLength_(centres_) {}

TubeSection Tube::at(double arcLength) const {
  const double fraction = arcLength_.parameter(arcLength);
  const auto after = std::upper_bound(stations_.begin() + 1, stations_.end() - 1, fraction,
                                      [](double f, const TubeStation& s) { return f < s.fraction; });
  const TubeStation& p = *(after - 1);
  const TubeStation& q = *after;
  const double t = (fraction - p.fraction) / (q.fraction - p.fraction);
  TubeSection section;
  section.centre = centres_.at(fraction);
  section.tangent = centres_.derivative(fraction).normalized();
  const Vector3d major = (1.0 - t) * p.major + t * q.major;
  section.major = (major - major.dot(section.tangent) * section.tangent).normalized();
  section.minor = section.tangent.cross(section.major);
  section.halfMajor = (1.0 - t) * p.halfMajor + t * q.halfMajor;
  section.halfMinor = (1.0 - t) * p.halfMinor + t * q.halfMinor;
  return section;
}

std::vector<Vector3d> Tube::centreline(int samples) const {
  std::vector<Vector3d> points;
  points.reserve(static_cast<std::size_t>(samples));
  for (int k = 0; k < samples; ++k) points.push_back(at(length() * k / (samples - 1)).centre);
  return points;
}

TriangleMesh tubeMesh(const Tube& tube, int rings, int sectors) {
  if (rings < 2 || sectors < 3) throw std::invalid_argument("tubeMesh: rings < 2 or sectors < 3");
  TriangleMesh mesh;
  mesh.points.push_back(tube.at(0.0).centre.cast<float>());
  const std::vector<Ring> along = ringsOf(tube, rings);
  for (const Ring& ring : along) {
    TubeSection section = tube.at(ring.arcLength);
    section.halfMajor *= ring.scale;
    section.halfMinor *= ring.scale;
    for (int k = 0; k < sectors; ++k) {
      mesh.points.push_back(section.pointAt(2.0 * std::numbers::pi * k / sectors).cast<float>());
    }
  }
  const int lastPole = static_cast<int>(mesh.points.size());
  mesh.points.push_back(tube.at(tube.length()).centre.cast<float>());

  const int lastRing = static_cast<int>(along.size()) - 1;
  const auto index = [&](int ring, int sector) { return 1 + ring * sectors + sector % sectors; };
  for (int k = 0; k < sectors; ++k) {
    mesh.triangles.emplace_back(0, index(0, k + 1), index(0, k));
    for (int r = 0; r < lastRing; ++r) {
      mesh.triangles.emplace_back(index(r, k), index(r, k + 1), index(r + 1, k + 1));
      mesh.triangles.emplace_back(index(r, k), index(r + 1, k + 1), index(r + 1, k));
    }
    mesh.triangles.emplace_back(lastPole, index(lastRing, k), index(lastRing, k + 1));
  }
  return mesh;
}

}  // namespace pleura
