#include <algorithm>
#include <cmath>

#include <pleura/nodes/deformable/springs/spring_energy.h>
#include <pleura/nodes/deformable/springs/spring_solver.h>
#include <pleura/nodes/deformable/springs/spring_start.h>
#include <pleura/nodes/deformable/springs/spring_system.h>

namespace pleura {
namespace {

using Eigen::Vector3d;

bool isInRange(const Vector3d& point) {
  return std::all_of(point.begin(), point.end(),
                     [](double x) { return std::isfinite(x) && std::abs(x) <= kSpringFarthest; });
}

bool areInRange(std::span<const Vector3d> points) {
  return std::all_of(points.begin(), points.end(), isInRange);
}

bool isSound(const SpringOptions& options) {
  return std::isfinite(options.tolerance) && options.tolerance > 0 && options.maxIterations > 0 &&
         options.maxLinearIterations > 0;
}

bool isSound(const SpringModel& model, double step, const SpringState& state) {
  constexpr double kShortest = 1e-6, kLongest = 1e3;  // [s]
  const std::size_t points = model.rest.size();
  return std::isfinite(step) && step >= kShortest && step <= kLongest && state.positions.size() == points &&
         state.velocities.size() == points && areInRange(state.positions) && areInRange(state.velocities);
}

// Marks the driven points. False if they aren't sound.
bool drive(SpringWorkspace& w, std::span<const int> driven, std::span<const Vector3d> targets) {
  std::fill(w.isDriven.begin(), w.isDriven.end(), std::uint8_t{0});
  if (driven.size() != targets.size() || !areInRange(targets)) return false;
  for (std::size_t i = 0; i < driven.size(); ++i) {
    const int point = driven[i];
    if (point < 0 || static_cast<std::size_t>(point) >= w.isDriven.size()) return false;
    if (w.isDriven[point] != 0 && w.direction[point] != targets[i]) return false;
    w.isDriven[point] = 1;
    w.direction[point] = targets[i];
  }
  return true;
}

// Puts driven points on their targets and displaces the others as the driven ones by the least sum of
// k |u_b - u_a|^2, and of inertia |u|^2.
void follow(const SpringModel& model, SpringWorkspace& w, std::span<const int> driven,
            std::span<const Vector3d> targets, const SpringOptions& options) {
  std::fill(w.gradient.begin(), w.gradient.end(), Vector3d::Zero());
  std::fill(w.direction.begin(), w.direction.end(), Vector3d::Zero());
  for (std::size_t i = 0; i < driven.size(); ++i) {
    w.direction[driven[i]] = targets[i] - w.position[driven[i]];
    w.position[driven[i]] = targets[i];
  }
  for (int a = 0; a < model.pointCount(); ++a)
    for (int s = model.begin[a]; s < model.begin[a + 1]; ++s) {
      const int b = model.end[s];
      w.tangent[s] = {Vector3d::Zero(), 0, w.stiffness[s]};
      const Vector3d f = w.stiffness[s] * (w.direction[b] - w.direction[a]);
      if (w.isDriven[a] == 0) w.gradient[a] -= f;
      if (w.isDriven[b] == 0) w.gradient[b] += f;
    }
  solveSpringSystem(model, w, 0, 0, 1e-3, options.maxLinearIterations);
  for (std::size_t i = 0; i < w.position.size(); ++i) w.position[i] += w.direction[i];
}

double dot(const SpringWorkspace::Vectors& a, const SpringWorkspace::Vectors& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += a[i].dot(b[i]);
  return sum;
}

// Moves the position along the direction by the first of 1, 1/2, 1/4 ... that lowers the energy enough
// (Armijo), or, where rounding hides that, the gradient.
bool searchLine(const SpringModel& model, SpringWorkspace& w, SpringEnergy& energy) {
  constexpr double kArmijo = 1e-4, kRounding = 1e-14;
  constexpr int kMaxHalvings = 50;
  const double slope = dot(w.gradient, w.direction);
  if (slope >= 0) return false;
  double step = 1;
  for (int halving = 0; halving < kMaxHalvings; ++halving, step /= 2) {
    for (std::size_t i = 0; i < w.trial.size(); ++i) w.trial[i] = w.position[i] + step * w.direction[i];
    if (!areInRange(w.trial)) continue;
    const SpringEnergy next = evaluateSprings(model, w);
    const bool isLower = next.energy <= energy.energy + kArmijo * step * slope;
    const bool isLevel = next.energy <= energy.energy + kRounding * energy.magnitude;
    if (isLower || (isLevel && next.unbalanced < energy.unbalanced)) {
      w.position.swap(w.trial);
      energy = next;
      return true;
    }
  }
  return false;
}

// Newton's method. A volume is held by raising the multiplier to the pressure whenever the forces balance
// better than the volume is kept.
void minimise(const SpringModel& model, SpringWorkspace& w, const SpringOptions& options, int minIterations,
              SpringReport& report) {
  constexpr double kLinearTolerance = 0.1, kLargestShift = 1e-3;
  const bool holds = std::holds_alternative<VolumeInterior>(model.interior);
  w.trial = w.position;
  SpringEnergy energy = evaluateSprings(model, w);
  for (;;) {
    report.residual = energy.unbalanced / model.forceUnit;
    const double excess = holds ? std::abs(energy.volume / model.restVolume - 1) : 0;
    report.converged = report.residual <= options.tolerance && excess <= options.tolerance;
    if (report.iterations >= options.maxIterations) break;
    if (report.converged && report.iterations >= minIterations) break;
    if (report.residual <= std::max(options.tolerance, 0.1 * excess)) {
      w.hold.multiplier = energy.interior.pressure;
      w.trial = w.position;
      energy = evaluateSprings(model, w);
    }
    ++report.iterations;
    const double shift = std::min(kLargestShift, report.residual);
    report.linearIterations += solveSpringSystem(model, w, energy.interior.slope, shift, kLinearTolerance,
                                                 options.maxLinearIterations);
    if (!searchLine(model, w, energy)) break;
  }
  report.volume = energy.volume;
  report.pressure = energy.interior.pressure;
}

Vector3d meanVelocity(const SpringModel& model, std::span<const Vector3d> velocities) {
  double mass = 0;
  Vector3d momentum = Vector3d::Zero();
  for (std::size_t i = 0; i < velocities.size(); ++i) {
    mass += model.mass[i];
    momentum += model.mass[i] * velocities[i];
  }
  return mass > 0 ? Vector3d(momentum / mass) : Vector3d::Zero();
}

// Of the points that aren't driven, beside a common velocity [J].
double kineticEnergy(const SpringModel& model, const SpringWorkspace& w, std::span<const Vector3d> velocities,
                     const Vector3d& common) {
  double energy = 0;
  for (std::size_t i = 0; i < velocities.size(); ++i)
    if (w.isDriven[i] == 0) energy += model.mass[i] * (velocities[i] - common).squaredNorm() / 2;
  return energy;
}

// Where the energy is not convex, as at a spring turning over, backward Euler can gain some. What is
// minimised falls from its value at the start, so the energy stored is never above `before`, and slowing down
// removes the gain.
void limitEnergy(const SpringModel& model, SpringWorkspace& w, double before, bool isFree,
                 SpringState& state) {
  const double left = before - storedEnergy(model, w, state.positions);
  const Vector3d common = isFree ? meanVelocity(model, state.velocities) : Vector3d::Zero();
  const double kinetic = kineticEnergy(model, w, state.velocities, common);
  if (kinetic <= left) return;
  const double factor = left > 0 ? std::sqrt(left / kinetic) : 0;
  for (std::size_t i = 0; i < state.velocities.size(); ++i)
    if (w.isDriven[i] == 0) state.velocities[i] = common + factor * (state.velocities[i] - common);
}

}  // namespace

SpringReport solveSprings(const SpringModel& model, SpringWorkspace& w, std::span<const int> driven,
                          std::span<const Vector3d> targets, const SpringOptions& options,
                          std::span<Vector3d> positions) {
  SpringReport report;
  report.refused = !isSound(options) || positions.size() != model.rest.size() || !drive(w, driven, targets);
  if (report.refused) return report;
  prepareForRest(model, w);
  const Eigen::Isometry3d motion = carryRigidly(model.rest, driven, targets);
  for (std::size_t i = 0; i < w.position.size(); ++i) w.position[i] = motion * model.rest[i];
  follow(model, w, driven, targets, options);
  minimise(model, w, options, 0, report);
  std::copy(w.position.begin(), w.position.end(), positions.begin());
  return report;
}

SpringState restingState(const SpringModel& model) {
  return {model.rest, std::vector<Vector3d>(model.rest.size(), Vector3d::Zero())};
}

SpringReport stepSprings(const SpringModel& model, SpringWorkspace& w, std::span<const int> driven,
                         std::span<const Vector3d> targets, double step, const SpringOptions& options,
                         SpringState& state) {
  SpringReport report;
  report.refused = !isSound(options) || !isSound(model, step, state) || !drive(w, driven, targets);
  if (report.refused) return report;
  const bool isFree = driven.empty();
  bool isLoaded = false;
  for (std::size_t i = 0; i < driven.size(); ++i) isLoaded |= targets[i] != state.positions[driven[i]];
  const Vector3d common = isFree ? meanVelocity(model, state.velocities) : Vector3d::Zero();
  const double before =
      storedEnergy(model, w, state.positions) + kineticEnergy(model, w, state.velocities, common);

  prepareForStep(model, w, state.positions, state.velocities, step);
  for (std::size_t i = 0; i < w.position.size(); ++i) w.position[i] = state.positions[i] + step * common;
  follow(model, w, driven, targets, options);
  minimise(model, w, options, 1, report);
  for (std::size_t i = 0; i < w.position.size(); ++i)
    state.velocities[i] = (w.position[i] - state.positions[i]) / step;
  state.positions = w.position;
  if (!isLoaded) limitEnergy(model, w, before, isFree, state);
  return report;
}

}  // namespace pleura
