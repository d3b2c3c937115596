#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include <Eigen/LU>

#include <pleura/nodes/lung/planar/planar_lung_system.h>

namespace pleura {
namespace {

using Eigen::Matrix2d;
using Eigen::Vector2d;

constexpr int kIterations = 200;
constexpr double kTolerance = 1e-8;  // of the forces that balance
constexpr double kShortest = 1e-9;   // [s] of a step
constexpr double kLongest = 1e9;
constexpr double kForce = 1e-3;  // [N] smaller ones count as this

void requirePositive(double value, const char* what) {
  if (!std::isfinite(value) || value <= 0)
    throw std::invalid_argument(std::string("planar lung: ") + what + " must be positive");
}

void check(const PlanarLungParameters& parameters) {
  for (const planar::ChestCoordinate* c : {&parameters.diaphragm, &parameters.chestWall}) {
    requirePositive(c->mass, "mass");
    requirePositive(c->stiffness, "stiffness");
    if (!std::isfinite(c->damping) || c->damping < 0)
      throw std::invalid_argument("planar lung: damping must not be negative");
  }
  requirePositive(parameters.thickness, "thickness");
  requirePositive(parameters.ambientPressure, "ambientPressure");
  requirePositive(parameters.contactPressure, "contactPressure");
  if (!std::isfinite(parameters.intrapleuralPressure) ||
      parameters.intrapleuralPressure <= -parameters.ambientPressure)
    throw std::invalid_argument("planar lung: intrapleuralPressure must be above that of a vacuum");
}

}  // namespace

PlanarLungSystem::Side::Side(const planar::SideParameters& lung, const PlanarLungParameters& parameters)
    : shape(planar::makeHemithorax(lung.shape)),
      tissue(shape.lung, lung.tissue, parameters.thickness),
      space(shape.wall, std::span(shape.lung.points).first(static_cast<std::size_t>(shape.lung.outlineCount)),
            tissue.firstFree, tissue.size() / 2, parameters.thickness, lung.shape.film,
            lung.shape.naturalScale, parameters.contactPressure),
      gas{false, 0, 0, parameters.ambientPressure},
      relaxationTime(lung.tissue.relaxationTime) {
  const Eigen::Index n = tissue.size();
  for (auto* x : {&u, &velocity, &increment, &direction, &trial, &placed, &force}) x->setZero(n);
  tangent.setZero(n, n);
  toChest.setZero(n, 2);
  solved.setZero(n, 2);
  factor.compute(Eigen::MatrixXd::Identity(n, n));  // has its memory, and a state that may be copied
}

PlanarLungSystem::PlanarLungSystem(const PlanarLungParameters& parameters)
    : mass_(parameters.diaphragm.mass, parameters.chestWall.mass),
      damping_(parameters.diaphragm.damping, parameters.chestWall.damping),
      stiffness_(parameters.diaphragm.stiffness, parameters.chestWall.stiffness),
      intrapleuralPressure_(parameters.intrapleuralPressure) {
  check(parameters);
  for (const planar::SideParameters& lung : parameters.lungs) {
    sides_.emplace_back(lung, parameters);
    if (!sides_.back().space.place(sides_.back().u, q_))
      throw std::invalid_argument("planar lung: the lung's natural shape does not fit its cavity");
  }
}

bool PlanarLungSystem::setPressure(std::size_t lung, double gauge) {
  planar::PleuralGas& gas = sides_[lung].gas;
  if (!std::isfinite(gauge) || gauge <= -gas.ambient) return false;
  gas.isSealed = false;
  gas.gauge = gauge;
  return true;
}

void PlanarLungSystem::seal(std::size_t lung) {
  Side& side = sides_[lung];
  if (side.gas.isSealed) return;
  side.gas.amount = (side.gas.ambient + side.gas.gauge) * side.space.volume();
  side.gas.isSealed = true;
}

PlanarLungStatus PlanarLungSystem::drawOut() {
  for (Side& side : sides_) {
    side.gasBefore = side.gas;
    side.gas.isSealed = false;
    side.gas.gauge = intrapleuralPressure_;
  }
  const PlanarLungStatus status = settle(Vector2d::Zero());
  for (std::size_t lung = 0; lung < sides_.size(); ++lung) {
    if (status.isConverged)
      seal(lung);
    else
      sides_[lung].gas = sides_[lung].gasBefore;
  }
  return status;
}

PlanarLungStatus PlanarLungSystem::step(double seconds, const Vector2d& muscles) {
  if (!std::isfinite(seconds) || seconds < kShortest || seconds > kLongest) return {};
  return solve(1 / seconds, muscles);
}

PlanarLungStatus PlanarLungSystem::settle(const Vector2d& muscles) { return solve(0, muscles); }

double PlanarLungSystem::pressure(std::size_t lung) const {
  return sides_[lung].gas.gaugeAt(sides_[lung].space.volume());
}

Vector2d PlanarLungSystem::meanAndLargestGap(std::size_t lung) const {
  return sides_[lung].space.meanAndLargestGap();
}

double PlanarLungSystem::energy() const {
  double energy = (mass_.cwiseProduct(velocity_).dot(velocity_) + stiffness_.cwiseProduct(q_).dot(q_)) / 2;
  for (const Side& side : sides_)
    energy += side.velocity.dot(side.tissue.mass * side.velocity) / 2 +
              side.u.dot(side.tissue.stiffness * side.u) / 2 + side.space.energy(side.gas);
  return energy;
}

void PlanarLungSystem::placeLung(std::size_t lung, std::span<Vector2d> points) const {
  sides_[lung].tissue.place(sides_[lung].u, points);
}

std::span<const Vector2d> PlanarLungSystem::wallPoints(std::size_t lung) const {
  return sides_[lung].space.wallPoints();
}

// Backward Euler for the increment d over a step, r = 1 / seconds (0: equilibrium):
//   f(u + d) + muscles - M (r^2 d - r v) - D r d - K (u + d) = 0,   v <- r d,   D = relaxationTime K
bool PlanarLungSystem::evaluate(double rate, const Vector2d& muscles, double part) {
  trial_ = increment_ + part * direction_;
  const Vector2d q = q_ + trial_;
  force_.setZero();
  scale_ = kForce;
  for (Side& side : sides_) {
    side.trial = side.increment + part * side.direction;
    side.placed = side.u + side.trial;
    if (!side.space.place(side.placed, q)) return false;
    side.force.setZero();
    side.space.addForces(side.gas, side.force, force_);
    scale_ = std::max(scale_, side.force.lpNorm<Eigen::Infinity>());
    side.placed += (rate * side.relaxationTime) * side.trial;
    side.force.noalias() -= side.tissue.stiffness.selfadjointView<Eigen::Lower>() * side.placed;
    if (rate > 0) {
      side.placed = rate * (rate * side.trial - side.velocity);
      side.force.noalias() -= side.tissue.mass.selfadjointView<Eigen::Lower>() * side.placed;
    }
  }
  const Vector2d elastic = stiffness_.cwiseProduct(q);
  const Vector2d viscous = rate * damping_.cwiseProduct(trial_);
  const Vector2d inertial = rate * mass_.cwiseProduct(rate * trial_ - velocity_);
  scale_ = std::max({scale_, force_.lpNorm<Eigen::Infinity>(), elastic.lpNorm<Eigen::Infinity>(),
                     viscous.lpNorm<Eigen::Infinity>(), inertial.lpNorm<Eigen::Infinity>()});
  force_ += muscles - elastic - viscous - inertial;
  return std::isfinite(largestForce());
}

double PlanarLungSystem::largestForce() const {
  double largest = force_.lpNorm<Eigen::Infinity>();
  for (const Side& side : sides_) largest = std::max(largest, side.force.lpNorm<Eigen::Infinity>());
  return largest;
}

double PlanarLungSystem::slope() const {
  double slope = -force_.dot(direction_);
  for (const Side& side : sides_) slope -= side.force.dot(side.direction);
  return slope;
}

// The tangent is an arrow: a block A a lung, each beside the chest's two columns B and its own C:
//   (C - sum B' A^-1 B) x_chest = f_chest - sum B' A^-1 f,   A x = f - B x_chest
bool PlanarLungSystem::factorise(double rate) {
  chestFactor_ = (stiffness_ + rate * damping_ + rate * rate * mass_).asDiagonal();
  for (Side& side : sides_) {
    side.tangent =
        (1 + rate * side.relaxationTime) * side.tissue.stiffness + (rate * rate) * side.tissue.mass;
    side.toChest.setZero();
    side.space.addStiffness(side.gas, side.tangent, side.toChest, chestFactor_);
    double shift = 0;
    while (side.factor.compute(side.tangent).info() != Eigen::Success) {  // not at a minimum yet
      const double more = std::max(shift, 1e-3 * side.tangent.diagonal().lpNorm<Eigen::Infinity>());
      if (!std::isfinite(more) || shift > 1e6 * side.tangent.diagonal().lpNorm<1>()) return false;
      side.tangent.diagonal().array() += more;
      shift += more;
    }
    side.solved = side.toChest;
    for (Eigen::Index c = 0; c < 2; ++c) {
      auto column = side.solved.col(c);
      side.factor.solveInPlace(column);
    }
    chestFactor_ -= side.toChest.transpose().lazyProduct(side.solved);
  }
  const double mean = chestFactor_.trace() / 2;
  const double least = mean - std::hypot((chestFactor_(0, 0) - chestFactor_(1, 1)) / 2, chestFactor_(0, 1));
  const double enough = 1e-2 * stiffness_.minCoeff();
  if (least < enough) chestFactor_.diagonal().array() += enough - least;
  return std::isfinite(chestFactor_.sum());
}

void PlanarLungSystem::direct() {
  Vector2d rest = force_;
  for (const Side& side : sides_) rest -= side.solved.transpose().lazyProduct(side.force);
  direction_ = chestFactor_.inverse() * rest;
  for (Side& side : sides_) {
    side.direction = side.force;
    side.factor.solveInPlace(side.direction);
    side.direction -= side.solved.lazyProduct(direction_);
  }
}

bool PlanarLungSystem::startFrom(double rate, const Vector2d& muscles, double seconds) {
  increment_ = seconds * velocity_;
  direction_.setZero();
  for (Side& side : sides_) {
    side.increment = seconds * side.velocity;
    side.direction.setZero();
  }
  return evaluate(rate, muscles, 0);
}

PlanarLungStatus PlanarLungSystem::solve(double rate, const Vector2d& muscles) {
  if (!std::isfinite(muscles.x()) || !std::isfinite(muscles.y())) return {};
  PlanarLungStatus status;
  bool isRight = (rate > 0 && startFrom(rate, muscles, 1 / rate)) || startFrom(rate, muscles, 0);
  double before = 0;  // [N] the residual the iteration before
  for (; isRight; ++status.iterations) {
    status.residual = largestForce();
    status.isConverged = status.residual <= kTolerance * scale_;
    if (status.isConverged || status.iterations == kIterations) break;
    // The factor serves on as long as it does its work.
    if (!(status.residual < 0.1 * before) && !factorise(rate)) break;
    before = status.residual;
    direct();
    // Along the direction, to where the slope of the potential has not turned up by more than half.
    const double slope0 = slope();
    if (slope0 >= 0) break;  // rounding is all that is left
    double part = 1;
    for (isRight = false; !isRight && part > 1e-12;) {
      if (!evaluate(rate, muscles, part)) {
        part /= 2;
        continue;
      }
      const double there = slope();
      isRight = there <= -0.5 * slope0;
      if (!isRight) part *= std::clamp(slope0 / (slope0 - there), 0.1, 0.7);
    }
    if (!isRight) break;
    increment_ = trial_;
    for (Side& side : sides_) side.increment = side.trial;
  }
  if (status.isConverged)
    commit(rate);
  else
    restore();
  return status;
}

void PlanarLungSystem::commit(double rate) {
  q_ += increment_;
  velocity_ = rate * increment_;
  for (Side& side : sides_) {
    side.u += side.increment;
    side.velocity = rate * side.increment;
  }
}

void PlanarLungSystem::restore() {
  for (Side& side : sides_) side.space.place(side.u, q_);
}

}  // namespace pleura
