#pragma once

#include <cmath>
#include <numbers>
#include <stdexcept>
#include <vector>

#include <pleura/nodes/lung/planar/planar_lung_system.h>
#include <pleura/nodes/lung/planar/polygon.h>

namespace pleura::planar {

constexpr double kPeriod = 4;            // [s] of a breath
constexpr double kInhale = kPeriod / 3;  // [s]
const Eigen::Vector2d kQuiet(9.5, 17);   // [N] at the end of a quiet inhale
const Eigen::Vector2d kNone(0, 0);

/// The muscles' part of their greatest force: it rises through the inhale, is let go in 0.2 s, and is gone.
inline double effort(double time) {
  const double t = std::fmod(time, kPeriod);
  const auto square = [](double x) { return x * x; };
  if (t < kInhale) return square(std::sin(std::numbers::pi / 2 * t / kInhale));
  if (t < kInhale + 0.2) return square(std::cos(std::numbers::pi / 2 * (t - kInhale) / 0.2));
  return 0;
}

/// Area of the intrapleural space by its triangles [m^2].
inline double stripArea(const PlanarLungSystem& system, std::size_t lung) {
  const Hemithorax& half = system.hemithorax(lung);
  std::vector<Eigen::Vector2d> points(half.lung.points.size());
  system.placeLung(lung, points);
  points.resize(static_cast<std::size_t>(half.lung.outlineCount));
  const auto wall = system.wallPoints(lung);
  points.insert(points.end(), wall.begin(), wall.end());
  double sum = 0;
  for (const Eigen::Vector3i& t : half.strip) {
    const auto p = [&](int k) { return points[static_cast<std::size_t>(t[k])]; };
    sum += cross(p(1) - p(0), p(2) - p(0)) / 2;
  }
  return sum;
}

inline PlanarLungSystem drawnOut(const PlanarLungParameters& parameters = {}) {
  PlanarLungSystem system(parameters);
  if (!system.drawOut().isConverged) throw std::runtime_error("the lung was not drawn out");
  return system;
}

inline PlanarLungParameters twoLungs() {
  PlanarLungParameters both;
  both.lungs = {SideParameters{}, SideParameters{}};
  both.lungs[1].shape.isMirrored = true;
  for (ChestCoordinate* c : {&both.diaphragm, &both.chestWall}) {
    c->mass *= 2;
    c->damping *= 2;
    c->stiffness *= 2;
  }
  return both;
}

/// What the next frame shows: every point of lungs and walls.
inline std::vector<double> stateOf(const PlanarLungSystem& system) {
  std::vector<double> state{system.chest().x(), system.chest().y()};
  for (std::size_t lung = 0; lung < system.lungCount(); ++lung) {
    std::vector<Eigen::Vector2d> points(system.hemithorax(lung).lung.points.size());
    system.placeLung(lung, points);
    for (const auto& p : points) state.insert(state.end(), {p.x(), p.y()});
    for (const auto& p : system.wallPoints(lung)) state.insert(state.end(), {p.x(), p.y()});
    state.push_back(system.pressure(lung));
  }
  return state;
}

}  // namespace pleura::planar
