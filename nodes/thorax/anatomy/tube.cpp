#include <pleura/nodes/thorax/anatomy/tube.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

namespace pleura {
namespace {

constexpr int kSamples = 512;
constexpr int kCapRings = 3;

using Eigen::Vector3d;

// Natural cubic spline: h0 M0 + 2 (h0 + h1) M1 + h1 M2 = 6 (d1 - d0), M = 0 at both ends (de Boor 1978, ch.
// IV).
std::vector<Vector3d> splineCurvature(const std::vector<TubeStation>& stations) {
  const Eigen::Index n = static_cast<Eigen::Index>(stations.size());
  Eigen::MatrixXd system = Eigen::MatrixXd::Identity(n, n);
  Eigen::MatrixX3d right = Eigen::MatrixX3d::Zero(n, 3);
  for (Eigen::Index i = 1; i + 1 < n; ++i) {
    const TubeStation& a = stations[static_cast<std::size_t>(i - 1)];
    const TubeStation& b = stations[static_cast<std::size_t>(i)];
    const TubeStation& c = stations[static_cast<std::size_t>(i + 1)];
    const double h0 = b.fraction - a.fraction;
    const double h1 = c.fraction - b.fraction;
    system.row(i).segment<3>(i - 1) << h0, 2.0 * (h0 + h1), h1;
    right.row(i) = 6.0 * ((c.centre - b.centre) / h1 - (b.centre - a.centre) / h0);
  }
  const Eigen::MatrixX3d solution = system.partialPivLu().solve(right);
  std::vector<Vector3d> curvature(stations.size());
  for (Eigen::Index i = 0; i < n; ++i) curvature[static_cast<std::size_t>(i)] = solution.row(i);
  return curvature;
}

void checkStations(const std::vector<TubeStation>& stations) {
  if (stations.size() < 2) throw std::invalid_argument("tube: stations: fewer than two");
  for (std::size_t i = 1; i < stations.size(); ++i) {
    if (!(stations[i - 1].fraction < stations[i].fraction)) {
      throw std::invalid_argument("tube: fraction: not strictly increasing");
    }
  }
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

Tube::Tube(std::vector<TubeStation> stations) : stations_(std::move(stations)) {
  checkStations(stations_);
  for (std::size_t i = 1; i < stations_.size(); ++i) {
    if (stations_[i].major.dot(stations_[i - 1].major) < 0.0) stations_[i].major *= -1.0;
  }
  curvature_ = splineCurvature(stations_);
  arcLength_.push_back(0.0);
  Vector3d last = stations_.front().centre;
  for (int k = 1; k <= kSamples; ++k) {
    const Vector3d next = sectionAtSample(k).centre;
    arcLength_.push_back(arcLength_.back() + (next - last).norm());
    last = next;
  }
}

TubeSection Tube::sectionAtFraction(double fraction) const {
  const auto after = std::upper_bound(stations_.begin() + 1, stations_.end() - 1, fraction,
                                      [](double f, const TubeStation& s) { return f < s.fraction; });
  const std::size_t i = static_cast<std::size_t>(after - stations_.begin());
  const TubeStation& p = stations_[i - 1];
  const TubeStation& q = stations_[i];
  const double h = q.fraction - p.fraction;
  const double t = std::clamp((fraction - p.fraction) / h, 0.0, 1.0);
  const double u = 1.0 - t;
  const Vector3d& m0 = curvature_[i - 1];
  const Vector3d& m1 = curvature_[i];

  TubeSection section;
  section.centre =
      u * p.centre + t * q.centre + (h * h / 6.0) * ((u * u * u - u) * m0 + (t * t * t - t) * m1);
  section.tangent =
      ((q.centre - p.centre) / h + (h / 6.0) * ((1.0 - 3.0 * u * u) * m0 + (3.0 * t * t - 1.0) * m1))
          .normalized();
  const Vector3d major = u * p.major + t * q.major;
  section.major = (major - major.dot(section.tangent) * section.tangent).normalized();
  section.minor = section.tangent.cross(section.major);
  section.halfMajor = u * p.halfMajor + t * q.halfMajor;
  section.halfMinor = u * p.halfMinor + t * q.halfMinor;
  return section;
}

TubeSection Tube::sectionAtSample(double sample) const {
  const double first = stations_.front().fraction;
  return sectionAtFraction(first + (stations_.back().fraction - first) * sample / kSamples);
}

TubeSection Tube::at(double arcLength) const {
  const auto after = std::upper_bound(arcLength_.begin() + 1, arcLength_.end() - 1, arcLength);
  const double before = *(after - 1);
  const double t = std::clamp((arcLength - before) / (*after - before), 0.0, 1.0);
  return sectionAtSample(static_cast<double>(after - arcLength_.begin()) - 1.0 + t);
}

std::vector<Vector3d> Tube::centreline(int samples) const {
  std::vector<Vector3d> points;
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
