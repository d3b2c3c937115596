#include "newton_solid.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace pleura {
namespace {

constexpr double kFarthest = 1e9;
constexpr int kMostHalvings = 30;
constexpr double kSufficient = 1e-4;      // Armijo's
constexpr double kRounding = 1e-14;       // of an energy
constexpr double kForceRounding = 1e-14;  // of a force, of stiffness times position

double freeDot(const SolidBody& body, const NodeVectors& a, const NodeVectors& b) {
  double sum = 0;
  for (const int i : body.unknowns) sum += a[i].dot(b[i]);
  return sum;
}

}  // namespace

NewtonSolid::NewtonSolid(SolidBody body, const NewtonOptions& options)
    : _body(std::move(body)),
      _options(options),
      _state{_body.rest, NodeVectors(_body.rest.size(), Eigen::Vector3d::Zero())} {
  if (options.iterations < 1 || !std::isfinite(options.tolerance) || options.tolerance <= 0)
    throw std::invalid_argument("solid: iterations below 1, or a tolerance that is not positive");
  for (NodeVectors* x :
       {&_forces, &_move, &_trial, &_direction, &_position, &_newForces, &_residual, &_damped})
    x->assign(_body.rest.size(), Eigen::Vector3d::Zero());
  for (BlockValues* values : {&_tangent, &_dampingTangent, &_system})
    values->assign(_body.pattern.slotCount(), Eigen::Matrix3d::Zero());
}

void NewtonSolid::start() {
  setState(_state);
  assemble(_tangent);
  for (const int i : _body.unknowns)
    _stiffnessNorm += _tangent[_body.pattern.begin[i]].diagonal().squaredNorm();
  _stiffnessNorm = std::sqrt(_stiffnessNorm);
  for (const double w : _body.elements.weight) _energyScale += w * _body.lame.mu;
}

bool NewtonSolid::setState(const SolidState& state) {
  if (!isUsable(_body, state)) return false;
  _state.position.assign(state.position.begin(), state.position.end());
  _state.velocity.assign(state.velocity.begin(), state.velocity.end());
  _energy = evaluate(_state.position, _forces);
  _isEvaluated = true;
  return true;
}

void NewtonSolid::addStepTerms(double h, const BlockValues& tangent, BlockValues& A) const {
  const double rate = 1 / h;  // 0 when static
  std::copy(tangent.begin(), tangent.end(), A.begin());
  if (_body.stiffnessDamping * rate > 0)
    for (std::size_t slot = 0; slot < A.size(); ++slot)
      A[slot] += _body.stiffnessDamping * rate * _dampingTangent[slot];
  for (std::size_t i = 0; i < _body.mass.size(); ++i)
    A[_body.pattern.begin[i]].diagonal().array() += (rate + _body.massDamping) * rate * _body.mass[i];
}

void NewtonSolid::assembleSystem(double h) {
  std::fill(_tangent.begin(), _tangent.end(), Eigen::Matrix3d::Zero());
  assemble(_tangent);
  addSoftStiffness(_body, _tangent);
  addStepTerms(h, _tangent, _system);
}

// Evaluates Phi at a move; false, and Phi infinite, when that is out of reach.
bool NewtonSolid::moveTo(double h, const SolidLoad& load, const NodeVectors& move) {
  _isEvaluated = false;
  _potential = std::numeric_limits<double>::infinity();
  for (const auto& d : move)
    for (const double x : d)
      if (!std::isfinite(x) || std::abs(x) > kFarthest) return false;
  flat(_position) = flat(_state.position) + flat(move);
  _newEnergy = evaluate(_position, _newForces);
  const double rate = 1 / h, soft = softEnergy(_body, load, _position);
  double work = 0, inertia = 0, momentum = 0, damping = 0;
  if (!load.forces.empty())
    for (std::size_t i = 0; i < move.size(); ++i) work += load.forces[i].dot(move[i]);
  if (rate > 0)
    for (std::size_t i = 0; i < move.size(); ++i) {
      inertia += 0.5 * (rate + _body.massDamping) * rate * _body.mass[i] * move[i].squaredNorm();
      momentum += rate * _body.mass[i] * move[i].dot(_state.velocity[i]);
    }
  if (_body.stiffnessDamping * rate > 0) {
    multiply(_body.pattern, _dampingTangent, move, _damped);
    damping = 0.5 * _body.stiffnessDamping * rate * flat(move).dot(flat(_damped));
  }
  _potential = _newEnergy + soft - work + inertia - momentum + damping;
  _magnitude = std::abs(_newEnergy) + soft + std::abs(work) + inertia + std::abs(momentum) + damping;
  return std::isfinite(_potential);
}

// -dPhi/dx at the move last evaluated.
void NewtonSolid::findResidual(double h, const SolidLoad& load, const NodeVectors& move) {
  const double rate = 1 / h, damping = _body.stiffnessDamping * rate;
  for (std::size_t i = 0; i < move.size(); ++i) {
    _residual[i] =
        _newForces[i] - _body.mass[i] * rate * ((rate + _body.massDamping) * move[i] - _state.velocity[i]);
    if (damping > 0) _residual[i] -= damping * _damped[i];
    if (!load.forces.empty()) _residual[i] += load.forces[i];
  }
  addSoftForces(_body, load, _position, _residual);
}

SolidReport NewtonSolid::failure(SolidOutcome outcome, const SolidReport& report) {
  return {outcome, report.iterations, report.residual};
}

SolidReport NewtonSolid::step(double h, const SolidLoad& load) {
  if (!isUsableStep(h) || !isUsable(_body, load)) return {SolidOutcome::badInput};
  if (h != _preparedFor) {
    _isSingular = !prepare(h);
    _preparedFor = h;
  }
  if (_isSingular) return {SolidOutcome::singular};
  SolidReport report;

  // Linearised at x0: A d = -dPhi/dx, with d known at the fixed nodes.
  if (!_isEvaluated) evaluate(_state.position, _newForces);
  std::fill(_tangent.begin(), _tangent.end(), Eigen::Matrix3d::Zero());
  assemble(_tangent);
  addSoftStiffness(_body, _tangent);
  if (_body.stiffnessDamping > 0) std::copy(_tangent.begin(), _tangent.end(), _dampingTangent.begin());
  addStepTerms(h, _tangent, _system);
  std::fill(_move.begin(), _move.end(), Eigen::Vector3d::Zero());
  std::fill(_damped.begin(), _damped.end(), Eigen::Vector3d::Zero());
  std::copy(_forces.begin(), _forces.end(), _newForces.begin());
  std::copy(_state.position.begin(), _state.position.end(), _position.begin());
  findResidual(h, load, _move);
  prescribe(_body, load, _state.position, _move);
  subtractFixed(_body, _system, _move, _residual);
  double farthest = 0;
  for (const auto& x : _state.position) farthest = std::max(farthest, x.cwiseAbs().maxCoeff());
  const double scale = freeNorm(_body, _residual) + flat(_forces).norm();
  const double rounding = kForceRounding * _stiffnessNorm * farthest;
  if (!solve(_system, _residual, _direction, report.iterations))
    return failure(SolidOutcome::singular, report);

  // Fixed nodes go at once; the others with them as the linearisation says if that is better than staying.
  const bool isDriven = flat(_move).cwiseAbs().maxCoeff() > 0;
  if (isDriven) {
    moveTo(h, load, _move);
    const double staying = _potential;
    flat(_trial) = flat(_move) + flat(_direction);
    if (moveTo(h, load, _trial) && _potential <= staying)
      std::swap(_move, _trial);
    else if (!moveTo(h, load, _move))
      return failure(SolidOutcome::failed, report);
  } else {
    _newEnergy = _energy;
    _potential = _energy + softEnergy(_body, load, _position);
    _magnitude = std::abs(_potential);
  }

  for (int linearisation = isDriven ? 1 : 0;; ++linearisation) {
    findResidual(h, load, _move);
    const double left = freeNorm(_body, _residual);
    report.residual = left > 0 ? left / (scale + rounding / _options.tolerance) : 0;
    report.outcome = report.residual <= _options.tolerance ? SolidOutcome::converged : SolidOutcome::stopped;
    if (left <= rounding) break;
    if (linearisation > 0) {
      if (report.converged() || linearisation == _options.iterations) break;
      assembleSystem(h);
      if (!solve(_system, _residual, _direction, report.iterations))
        return failure(SolidOutcome::failed, report);
    }
    const double before = _potential, slope = freeDot(_body, _residual, _direction);
    const double slack = kRounding * (_magnitude + _energyScale + flat(_newForces).norm() * farthest);
    double length = 1;
    for (int halvings = 0;; ++halvings, length *= 0.5) {
      if (halvings > kMostHalvings) return failure(SolidOutcome::failed, report);
      flat(_trial) = flat(_move) + length * flat(_direction);
      if (moveTo(h, load, _trial) && _potential <= before - kSufficient * length * slope + slack) break;
    }
    std::swap(_move, _trial);
  }

  std::swap(_state.position, _position);
  std::swap(_forces, _newForces);
  _energy = _newEnergy;
  _isEvaluated = true;
  flat(_state.velocity) = 1 / h * flat(_move);
  return report;
}

}  // namespace pleura
