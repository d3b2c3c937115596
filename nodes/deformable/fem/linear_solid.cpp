#include <algorithm>
#include <cmath>

#include <pleura/nodes/deformable/fem/linear_solid.h>

namespace pleura {
namespace {

constexpr double kRefined = 1e-9;
constexpr double kConverged = 1e-6;
constexpr int kMostSolves = 4;

BlockValues stiffnessOf(const SolidBody& body) {
  const SolidElements& elements = body.elements;
  const int n = elements.nodesPerElement, points = elements.pointsPerElement;
  BlockValues values(body.pattern.slotCount(), Eigen::Matrix3d::Zero());
  auto slot = body.elementSlots.begin();
  for (int e = 0; e < elements.count(); ++e) {
    const Eigen::Vector3d* mean = elements.meanGradient.data() + std::ptrdiff_t{e} * n;
    for (int a = 0; a < n; ++a)
      for (int b = a; b < n; ++b) {
        Eigen::Matrix3d block = Eigen::Matrix3d::Zero();
        for (int q = e * points; q < (e + 1) * points; ++q) {
          const Eigen::Vector3d* g = elements.gradientsAt(q);
          block += stiffnessBlock(body.lame, elements.weight[q], g[a], g[b], mean[a], mean[b]);
        }
        addBlock(values, *slot++, block);
      }
  }
  return values;
}

}  // namespace

LinearSolid::LinearSolid(const SolidMesh& mesh, const SolidMaterial& material,
                         const SolidConstraints& constraints)
    : body_(makeSolidBody(mesh, material, constraints)),
      state_{body_.rest, NodeVectors(body_.rest.size(), Eigen::Vector3d::Zero())},
      stiffness_(stiffnessOf(body_)),
      total_(stiffness_),
      system_(stiffness_),
      factor_(body_.pattern, body_.unknowns) {
  addSoftStiffness(body_, total_);
  for (NodeVectors* x : {&displacement_, &restoring_, &load_, &right_, &move_, &correction_,
                         &newDisplacement_, &newRestoring_, &residual_})
    x->assign(body_.rest.size(), Eigen::Vector3d::Zero());
}

bool LinearSolid::setState(const SolidState& state) {
  if (!isUsable(body_, state)) return false;
  state_.position.assign(state.position.begin(), state.position.end());
  state_.velocity.assign(state.velocity.begin(), state.velocity.end());
  flat(displacement_) = flat(state_.position) - flat(body_.rest);
  multiply(body_.pattern, total_, displacement_, restoring_);
  return true;
}

double LinearSolid::energy() const {
  double twice = 0;
  NodeVectors force(body_.rest.size());
  multiply(body_.pattern, stiffness_, displacement_, force);
  for (std::size_t i = 0; i < force.size(); ++i) twice += force[i].dot(displacement_[i]);
  return 0.5 * twice;
}

bool LinearSolid::prepare(double h) {
  if (h == factorisedFor_) return !isSingular_;
  const double rate = 1 / h;  // 0 when static
  for (std::size_t slot = 0; slot < system_.size(); ++slot)
    system_[slot] = (1 + body_.stiffnessDamping * rate) * total_[slot];
  addInertia(body_, rate, system_);
  factorisedFor_ = h;
  isSingular_ = !factor_.factorise(body_.pattern, system_);
  return !isSingular_;
}

// r = load + M v0/h - S u1 - (1/h^2 + alpha/h) M d - beta/h S d, of the step d = move_ to u1 =
// newDisplacement_.
void LinearSolid::residualAfter(double h, NodeVectors& residual) {
  const double rate = 1 / h, damping = body_.stiffnessDamping * rate;
  flat(newDisplacement_) = flat(displacement_) + flat(move_);
  multiply(body_.pattern, total_, newDisplacement_, newRestoring_);
  for (std::size_t i = 0; i < residual.size(); ++i)
    residual[i] = load_[i] - newRestoring_[i] - damping * (newRestoring_[i] - restoring_[i]) +
                  body_.mass[i] * rate * (state_.velocity[i] - (rate + body_.massDamping) * move_[i]);
}

SolidReport LinearSolid::step(double h, const SolidLoad& load) {
  if (!isUsableStep(h) || !isUsable(body_, load)) return {SolidOutcome::badInput};
  if (!prepare(h)) return {SolidOutcome::singular};
  // A d = load + M v0/h - S u0, d known at the fixed nodes.
  const double rate = 1 / h;
  if (load.forces.empty())
    std::fill(load_.begin(), load_.end(), Eigen::Vector3d::Zero());
  else
    std::copy(load.forces.begin(), load.forces.end(), load_.begin());
  addSoftForces(body_, load, body_.rest, load_);
  prescribe(body_, load, state_.position, move_);
  for (std::size_t i = 0; i < right_.size(); ++i)
    right_[i] = load_[i] - restoring_[i] + body_.mass[i] * rate * state_.velocity[i];
  subtractFixed(body_, system_, move_, right_);
  const double scale = freeNorm(body_, right_) + flat(restoring_).norm();

  SolidReport report;
  for (; report.iterations < kMostSolves && (report.iterations == 0 || report.residual > kRefined);
       ++report.iterations) {
    factor_.solve(report.iterations == 0 ? right_ : residual_, correction_);
    flat(move_) += flat(correction_);
    residualAfter(h, residual_);
    const double left = freeNorm(body_, residual_);
    report.residual = scale > 0 ? left / scale : 0;
  }
  for (std::size_t i = 0; i < move_.size(); ++i) correction_[i] = body_.rest[i] + newDisplacement_[i];
  std::swap(state_.position, correction_);
  std::swap(displacement_, newDisplacement_);
  std::swap(restoring_, newRestoring_);
  flat(state_.velocity) = rate * flat(move_);
  if (report.residual > kConverged) report.outcome = SolidOutcome::stopped;
  return report;
}

}  // namespace pleura
