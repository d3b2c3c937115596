#include <algorithm>
#include <cmath>
#include <cstddef>
#include <stdexcept>

#include <pleura/nodes/deformable/fem/pressure.h>
#include <pleura/nodes/deformable/mesh/measures.h>
#include <pleura/nodes/deformable/mesh/precision.h>
#include <pleura/nodes/lung/shape/freed_lung.h>

namespace pleura {

namespace {

/// k = kWallStiffness times a point's area: at the 500 Pa of a resting lung it sinks half a millimetre in.
constexpr double kWallStiffness = 1e6;  // [Pa/m]

/// Room that rounding does not use up.
constexpr float kLeastRoom = 1e-5f;  // [m]

std::size_t at(int i) { return static_cast<std::size_t>(i); }

/// The nodes whose elements hold points of the hilum.
std::vector<int> nodesOf(const Embedding& embedding, std::span<const int> hilum) {
  std::vector<int> nodes;
  for (const int point : hilum) {
    if (point < 0 || point >= embedding.size())
      throw std::invalid_argument("hilum: there is no point " + std::to_string(point));
    const auto first = embedding.nodes.begin() + std::ptrdiff_t{8} * point;
    nodes.insert(nodes.end(), first, first + 8);
  }
  std::sort(nodes.begin(), nodes.end());
  nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
  if (nodes.empty()) throw std::invalid_argument("hilum: a lung that nothing holds");
  return nodes;
}

/// A third of the triangles around each point [m^2].
std::vector<double> areasOf(const TriangleMesh& mesh) {
  std::vector<double> area(mesh.points.size(), 0.0);
  for (const Eigen::Vector3i& t : mesh.triangles) {
    const Eigen::Vector3d a = mesh.points[at(t[0])].cast<double>();
    const Eigen::Vector3d b = mesh.points[at(t[1])].cast<double>(), c = mesh.points[at(t[2])].cast<double>();
    for (const int corner : t) area[at(corner)] += (b - a).cross(c - a).norm() / 6;
  }
  return area;
}

}  // namespace

FreedLung::FreedLung(const TriangleMesh& rest, std::span<const int> hilum, const FreedLungMaterial& material)
    : FreedLung(makeLattice(rest, {.elements = material.elements}), rest, hilum, material) {}

FreedLung::FreedLung(const Lattice& lattice, const TriangleMesh& rest, std::span<const int> hilum,
                     const FreedLungMaterial& material)
    : rest_(rest),
      hilum_(hilum.begin(), hilum.end()),
      embedding_(embed(lattice, rest.points)),
      solid_(lattice.solid, {.youngsModulus = 1, .poissonRatio = material.poissonRatio},
             {.fixed = nodesOf(embedding_, hilum), .soft = {}}),
      factor_(solid_.body().pattern, solid_.body().unknowns),
      pull_(lattice.solid.nodes.size(), Eigen::Vector3d::Zero()),
      area_(areasOf(rest)),
      system_(solid_.stiffness()),
      right_(pull_),
      held_(pull_),
      byWall_(pull_),
      byPressure_(pull_),
      base_(rest.points.size()),
      slope_(rest.points.size()),
      normals_(rest.points.size()),
      wall_(rest.points, rest.triangles),
      room_(rest.points.size()),
      touches_(rest.points.size()) {
  if (!(material.compliance > 0) || !std::isfinite(material.compliance))
    throw std::invalid_argument("compliance: above 0 is expected");
  std::vector<Eigen::Vector3d> forces(rest.points.size(), Eigen::Vector3d::Zero());
  inDouble(rest.points, base_);
  addPressureForces(1, base_, rest.triangles, forces);
  addTransposed(embedding_, forces, pull_);
  if (!factor_.factorise(solid_.body().pattern, system_))
    throw std::invalid_argument("hilum: it does not hold the lung");
  factor_.solve(pull_, byPressure_);
  youngsModulus_ = flat(pull_).dot(flat(byPressure_)) / material.compliance;
}

/// The hilum goes with the middle of where the wall would have it.
void FreedLung::takeHilum(std::span<const Eigen::Vector3f> cavity) {
  Eigen::Vector3d move = Eigen::Vector3d::Zero();
  for (const int point : hilum_) move += (cavity[at(point)] - rest_.points[at(point)]).cast<double>();
  move /= static_cast<double>(hilum_.size());
  std::fill(held_.begin(), held_.end(), Eigen::Vector3d::Zero());
  for (const int node : solid_.body().constraints.fixed) held_[at(node)] = move;
}

/// A = K + sum of k_i (w_i n_i) (w_i n_i)^T and b = sum of k_i w_i n_i (n_i.(c_i - X_i)) over points that
/// touch.
void FreedLung::addWall(std::span<const Eigen::Vector3f> cavity) {
  const SolidBody& body = solid_.body();
  std::transform(solid_.stiffness().begin(), solid_.stiffness().end(), system_.begin(),
                 [this](const Eigen::Matrix3d& block) { return Eigen::Matrix3d(youngsModulus_ * block); });
  std::fill(right_.begin(), right_.end(), Eigen::Vector3d::Zero());
  for (std::size_t i = 0; i < touches_.size(); ++i) {
    if (touches_[i] == 0) continue;
    const Eigen::Vector3d n = normals_[i].cast<double>();
    const double k = kWallStiffness * area_[i];
    const double gap = n.dot((cavity[i] - rest_.points[i]).cast<double>());
    const double* w = &embedding_.weights[8 * i];
    const int* node = &embedding_.nodes[8 * i];
    const int* slot = &body.elementSlots[36 * at(embedding_.elements[i])];
    for (int a = 0; a < 8; ++a) {
      right_[at(node[a])] += k * w[a] * gap * n;
      for (int b = a; b < 8; ++b) addBlock(system_, *slot++, k * w[a] * w[b] * n * n.transpose());
    }
  }
}

bool FreedLung::solve() {
  const SolidBody& body = solid_.body();
  if (!factor_.factorise(body.pattern, system_)) return false;
  subtractFixed(body, system_, held_, right_);
  factor_.solve(right_, byWall_);
  for (const int node : body.constraints.fixed) byWall_[at(node)] = held_[at(node)];
  factor_.solve(pull_, byPressure_);
  interpolate(embedding_, byWall_, base_);
  interpolate(embedding_, byPressure_, slope_);
  for (std::size_t i = 0; i < base_.size(); ++i) base_[i] += rest_.points[i].cast<double>();
  return true;
}

/// Regula falsi (Illinois) on V(base + q slope), within the pressures that a lung can have.
double FreedLung::inflate(double volume, std::span<Eigen::Vector3f> points) const {
  const auto excess = [&](double q) {
    for (std::size_t i = 0; i < points.size(); ++i) points[i] = (base_[i] + q * slope_[i]).cast<float>();
    return signedVolume(points, rest_.triangles) - volume;
  };
  constexpr double kMost = 20e3;  // [Pa]
  double q = 0, e = excess(q);
  double other = e > 0 ? -1 : 1;
  double f = excess(other * 100);
  other *= 100;
  while (e * f > 0 && std::abs(other) < kMost) f = excess(other *= 2);
  if (e * f > 0) return other;  // no pressure gives that volume: as near as they come
  constexpr int kSteps = 60;
  for (int k = 0; k < kSteps && std::abs(e) > 1e-9; ++k) {
    const double next = q - e * (other - q) / (f - e);
    const double g = excess(next);
    if (g * e < 0) {
      other = q;
      f = e;
    } else {
      f /= 2;
    }
    q = next;
    e = g;
  }
  return q;
}

bool FreedLung::touch(std::span<const Eigen::Vector3f> cavity, std::span<const Eigen::Vector3f> points) {
  bool hasChanged = false;
  for (std::size_t i = 0; i < touches_.size(); ++i) {
    const char now = normals_[i].dot(points[i] - cavity[i]) > 0 ? 1 : 0;
    hasChanged = hasChanged || now != touches_[i];
    touches_[i] = now;
  }
  return hasChanged;
}

double FreedLung::keepInside(const Eigen::Vector3f& onWall, Eigen::Vector3f& point) const {
  constexpr double kRounding = 1.001;
  const Eigen::Vector3d p = point.cast<double>();
  const double reach = kRounding * (p - onWall.cast<double>()).norm();
  const auto nearest = wall_.closestPointWithin(p, reach);
  if (!nearest) return 0;
  if (wall_.pseudonormal(*nearest).dot(p - nearest->point) <= 0) return nearest->distance;
  point = nearest->point.cast<float>();
  return 0;
}

void FreedLung::keepInside(std::span<const Eigen::Vector3f> cavity, std::span<Eigen::Vector3f> points) {
  constexpr float kUnknown = -1;
  wall_.refit(cavity);
  std::fill(room_.begin(), room_.end(), kUnknown);
  for (const Eigen::Vector3i& triangle : rest_.triangles) {
    for (const int corner : triangle) {
      float& room = room_[at(corner)];
      if (room != kUnknown) continue;
      Eigen::Vector3f& point = points[at(corner)];
      for (const int other : triangle)
        room = std::max(room, room_[at(other)] - (points[at(other)] - point).norm());
      if (room <= kLeastRoom) room = static_cast<float>(keepInside(cavity[at(corner)], point));
    }
  }
}

void FreedLung::settle(double volume, std::span<const Eigen::Vector3f> cavity,
                       std::span<Eigen::Vector3f> points, FreedLungReport& report) {
  constexpr int kMostSolves = 12;
  for (int k = 0; k < kMostSolves && !report.hasConverged; ++k) {
    addWall(cavity);
    ++report.solves;
    if (!solve()) return;
    report.pressure = inflate(volume, points);
    report.hasConverged = !touch(cavity, points);
  }
}

FreedLungReport FreedLung::shape(double volume, std::span<const Eigen::Vector3f> cavity,
                                 std::span<Eigen::Vector3f> points) {
  FreedLungReport report;
  vertexNormals(cavity, rest_.triangles, normals_);
  takeHilum(cavity);
  settle(volume, cavity, points, report);
  if (!report.hasConverged) {
    std::fill(touches_.begin(), touches_.end(), char{0});
    settle(volume, cavity, points, report);
  }
  report.touching = static_cast<int>(std::count(touches_.begin(), touches_.end(), char{1}));
  keepInside(cavity, points);
  return report;
}

}  // namespace pleura
