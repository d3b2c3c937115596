#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include <pleura/nodes/deformable/fem/newton_solid.h>

namespace pleura {
namespace {

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
    : body_(std::move(body)),
      options_(options),
      state_{body_.rest, NodeVectors(body_.rest.size(), Eigen::Vector3d::Zero())} {
  if (options.iterations < 1 || !std::isfinite(options.tolerance) || options.tolerance <= 0)
    throw std::invalid_argument("solid: iterations below 1, or a tolerance that is not positive");
  for (NodeVectors* x :
       {&forces_, &move_, &trial_, &direction_, &position_, &newForces_, &residual_, &damped_})
    x->assign(body_.rest.size(), Eigen::Vector3d::Zero());
  for (BlockValues* values : {&tangent_, &dampingTangent_, &system_})
    values->assign(body_.pattern.slotCount(), Eigen::Matrix3d::Zero());
}

void NewtonSolid::start() {
  setState(state_);
  assemble(tangent_);
  for (const int i : body_.unknowns)
    stiffnessNorm_ += tangent_[body_.pattern.begin[i]].diagonal().squaredNorm();
  stiffnessNorm_ = std::sqrt(stiffnessNorm_);
  for (const double w : body_.elements.weight) energyScale_ += w * body_.lame.mu;
}

bool NewtonSolid::setState(const SolidState& state) {
  if (!isUsable(body_, state)) return false;
  state_.position.assign(state.position.begin(), state.position.end());
  state_.velocity.assign(state.velocity.begin(), state.velocity.end());
  energy_ = evaluate(state_.position, forces_);
  isEvaluated_ = true;
  return true;
}

void NewtonSolid::addStepTerms(double h, const BlockValues& tangent, BlockValues& A) const {
  const double rate = 1 / h;  // 0 when static
  std::copy(tangent.begin(), tangent.end(), A.begin());
  if (body_.stiffnessDamping * rate > 0)
    for (std::size_t slot = 0; slot < A.size(); ++slot)
      A[slot] += body_.stiffnessDamping * rate * dampingTangent_[slot];
  addInertia(body_, rate, A);
}

void NewtonSolid::assembleSystem(double h) {
  std::fill(tangent_.begin(), tangent_.end(), Eigen::Matrix3d::Zero());
  assemble(tangent_);
  addSoftStiffness(body_, tangent_);
  addStepTerms(h, tangent_, system_);
}

// Evaluates Phi at a move; false, and Phi infinite, when that is out of reach.
bool NewtonSolid::moveTo(double h, const SolidLoad& load, const NodeVectors& move) {
  isEvaluated_ = false;
  potential_ = std::numeric_limits<double>::infinity();
  for (const auto& d : move)
    for (const double x : d)
      if (!std::isfinite(x) || std::abs(x) > kFarthestNode) return false;
  flat(position_) = flat(state_.position) + flat(move);
  newEnergy_ = evaluate(position_, newForces_);
  const double rate = 1 / h, soft = softEnergy(body_, load, position_);
  double work = 0, inertia = 0, momentum = 0, damping = 0;
  if (!load.forces.empty())
    for (std::size_t i = 0; i < move.size(); ++i) work += load.forces[i].dot(move[i]);
  if (rate > 0)
    for (std::size_t i = 0; i < move.size(); ++i) {
      inertia += 0.5 * (rate + body_.massDamping) * rate * body_.mass[i] * move[i].squaredNorm();
      momentum += rate * body_.mass[i] * move[i].dot(state_.velocity[i]);
    }
  if (body_.stiffnessDamping * rate > 0) {
    multiply(body_.pattern, dampingTangent_, move, damped_);
    damping = 0.5 * body_.stiffnessDamping * rate * flat(move).dot(flat(damped_));
  }
  potential_ = newEnergy_ + soft - work + inertia - momentum + damping;
  magnitude_ = std::abs(newEnergy_) + soft + std::abs(work) + inertia + std::abs(momentum) + damping;
  return std::isfinite(potential_);
}

// -dPhi/dx at the move last evaluated.
void NewtonSolid::findResidual(double h, const SolidLoad& load, const NodeVectors& move) {
  const double rate = 1 / h, damping = body_.stiffnessDamping * rate;
  for (std::size_t i = 0; i < move.size(); ++i) {
    residual_[i] =
        newForces_[i] - body_.mass[i] * rate * ((rate + body_.massDamping) * move[i] - state_.velocity[i]);
    if (damping > 0) residual_[i] -= damping * damped_[i];
    if (!load.forces.empty()) residual_[i] += load.forces[i];
  }
  addSoftForces(body_, load, position_, residual_);
}

SolidReport NewtonSolid::failure(SolidOutcome outcome, const SolidReport& report) {
  return {outcome, report.iterations, report.residual};
}

SolidReport NewtonSolid::step(double h, const SolidLoad& load) {
  if (!isUsableStep(h) || !isUsable(body_, load)) return {SolidOutcome::badInput};
  if (h != preparedFor_) {
    isSingular_ = !prepare(h);
    preparedFor_ = h;
  }
  if (isSingular_) return {SolidOutcome::singular};
  SolidReport report;

  // Linearised at x0: A d = -dPhi/dx, with d known at the fixed nodes.
  if (!isEvaluated_) evaluate(state_.position, newForces_);
  std::fill(tangent_.begin(), tangent_.end(), Eigen::Matrix3d::Zero());
  assemble(tangent_);
  addSoftStiffness(body_, tangent_);
  if (body_.stiffnessDamping > 0) std::copy(tangent_.begin(), tangent_.end(), dampingTangent_.begin());
  addStepTerms(h, tangent_, system_);
  std::fill(move_.begin(), move_.end(), Eigen::Vector3d::Zero());
  std::fill(damped_.begin(), damped_.end(), Eigen::Vector3d::Zero());
  std::copy(forces_.begin(), forces_.end(), newForces_.begin());
  std::copy(state_.position.begin(), state_.position.end(), position_.begin());
  findResidual(h, load, move_);
  prescribe(body_, load, state_.position, move_);
  subtractFixed(body_, system_, move_, residual_);
  double farthest = 0;
  for (const auto& x : state_.position) farthest = std::max(farthest, x.cwiseAbs().maxCoeff());
  const double scale = freeNorm(body_, residual_) + flat(forces_).norm();
  const double rounding = kForceRounding * stiffnessNorm_ * farthest;
  if (!solve(system_, residual_, direction_, report.iterations))
    return failure(SolidOutcome::singular, report);

  // Fixed nodes go at once; the others with them as the linearisation says if that is better than staying.
  const bool isDriven = flat(move_).cwiseAbs().maxCoeff() > 0;
  if (isDriven) {
    moveTo(h, load, move_);
    const double staying = potential_;
    flat(trial_) = flat(move_) + flat(direction_);
    if (moveTo(h, load, trial_) && potential_ <= staying)
      std::swap(move_, trial_);
    else if (!moveTo(h, load, move_))
      return failure(SolidOutcome::failed, report);
  } else {
    newEnergy_ = energy_;
    potential_ = energy_ + softEnergy(body_, load, position_);
    magnitude_ = std::abs(potential_);
  }

  for (int linearisation = isDriven ? 1 : 0;; ++linearisation) {
    findResidual(h, load, move_);
    const double left = freeNorm(body_, residual_);
    report.residual = left > 0 ? left / (scale + rounding / options_.tolerance) : 0;
    report.outcome = report.residual <= options_.tolerance ? SolidOutcome::converged : SolidOutcome::stopped;
    if (left <= rounding) break;
    if (linearisation > 0) {
      if (report.converged() || linearisation == options_.iterations) break;
      assembleSystem(h);
      if (!solve(system_, residual_, direction_, report.iterations))
        return failure(SolidOutcome::failed, report);
    }
    const double before = potential_, slope = freeDot(body_, residual_, direction_);
    const double slack = kRounding * (magnitude_ + energyScale_ + flat(newForces_).norm() * farthest);
    double length = 1;
    for (int halvings = 0;; ++halvings, length *= 0.5) {
      if (halvings > kMostHalvings) return failure(SolidOutcome::failed, report);
      flat(trial_) = flat(move_) + length * flat(direction_);
      if (moveTo(h, load, trial_) && potential_ <= before - kSufficient * length * slope + slack) break;
    }
    std::swap(move_, trial_);
  }

  std::swap(state_.position, position_);
  std::swap(forces_, newForces_);
  energy_ = newEnergy_;
  isEvaluated_ = true;
  flat(state_.velocity) = 1 / h * flat(move_);
  return report;
}

}  // namespace pleura
