#include "linear_solid.h"

#include <algorithm>
#include <cmath>

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
    const Eigen::Vector3d* mean = &elements.meanGradient[e * n];
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
    : _body(makeSolidBody(mesh, material, constraints)),
      _state{_body.rest, NodeVectors(_body.rest.size(), Eigen::Vector3d::Zero())},
      _stiffness(stiffnessOf(_body)),
      _total(_stiffness),
      _system(_stiffness),
      _factor(_body.pattern, _body.unknowns) {
  addSoftStiffness(_body, _total);
  for (NodeVectors* x : {&_displacement, &_restoring, &_load, &_right, &_move, &_correction,
                         &_newDisplacement, &_newRestoring, &_residual})
    x->assign(_body.rest.size(), Eigen::Vector3d::Zero());
}

bool LinearSolid::setState(const SolidState& state) {
  if (!isUsable(_body, state)) return false;
  _state.position.assign(state.position.begin(), state.position.end());
  _state.velocity.assign(state.velocity.begin(), state.velocity.end());
  flat(_displacement) = flat(_state.position) - flat(_body.rest);
  multiply(_body.pattern, _total, _displacement, _restoring);
  return true;
}

double LinearSolid::energy() const {
  double twice = 0;
  NodeVectors force(_body.rest.size());
  multiply(_body.pattern, _stiffness, _displacement, force);
  for (std::size_t i = 0; i < force.size(); ++i) twice += force[i].dot(_displacement[i]);
  return 0.5 * twice;
}

bool LinearSolid::prepare(double h) {
  if (h == _factorisedFor) return !_isSingular;
  const double rate = 1 / h;  // 0 when static
  for (std::size_t slot = 0; slot < _system.size(); ++slot)
    _system[slot] = (1 + _body.stiffnessDamping * rate) * _total[slot];
  for (std::size_t i = 0; i < _body.mass.size(); ++i)
    _system[_body.pattern.begin[i]].diagonal().array() += (rate + _body.massDamping) * rate * _body.mass[i];
  _factorisedFor = h;
  _isSingular = !_factor.factorise(_body.pattern, _system);
  return !_isSingular;
}

// r = load + M v0/h - S u1 - (1/h^2 + alpha/h) M d - beta/h S d, of the step d = _move to u1 =
// _newDisplacement.
void LinearSolid::residualAfter(double h, NodeVectors& residual) {
  const double rate = 1 / h, damping = _body.stiffnessDamping * rate;
  flat(_newDisplacement) = flat(_displacement) + flat(_move);
  multiply(_body.pattern, _total, _newDisplacement, _newRestoring);
  for (std::size_t i = 0; i < residual.size(); ++i)
    residual[i] = _load[i] - _newRestoring[i] - damping * (_newRestoring[i] - _restoring[i]) +
                  _body.mass[i] * rate * (_state.velocity[i] - (rate + _body.massDamping) * _move[i]);
}

SolidReport LinearSolid::step(double h, const SolidLoad& load) {
  if (!isUsableStep(h) || !isUsable(_body, load)) return {SolidOutcome::badInput};
  if (!prepare(h)) return {SolidOutcome::singular};
  // A d = load + M v0/h - S u0, d known at the fixed nodes.
  const double rate = 1 / h;
  if (load.forces.empty())
    std::fill(_load.begin(), _load.end(), Eigen::Vector3d::Zero());
  else
    std::copy(load.forces.begin(), load.forces.end(), _load.begin());
  addSoftForces(_body, load, _body.rest, _load);
  prescribe(_body, load, _state.position, _move);
  for (std::size_t i = 0; i < _right.size(); ++i)
    _right[i] = _load[i] - _restoring[i] + _body.mass[i] * rate * _state.velocity[i];
  subtractFixed(_body, _system, _move, _right);
  const double scale = freeNorm(_body, _right) + flat(_restoring).norm();

  SolidReport report;
  for (; report.iterations < kMostSolves && (report.iterations == 0 || report.residual > kRefined);
       ++report.iterations) {
    _factor.solve(report.iterations == 0 ? _right : _residual, _correction);
    flat(_move) += flat(_correction);
    residualAfter(h, _residual);
    const double left = freeNorm(_body, _residual);
    report.residual = scale > 0 ? left / scale : 0;
  }
  for (std::size_t i = 0; i < _move.size(); ++i) _correction[i] = _body.rest[i] + _newDisplacement[i];
  std::swap(_state.position, _correction);
  std::swap(_displacement, _newDisplacement);
  std::swap(_restoring, _newRestoring);
  flat(_state.velocity) = rate * flat(_move);
  if (report.residual > kConverged) report.outcome = SolidOutcome::stopped;
  return report;
}

}  // namespace pleura
