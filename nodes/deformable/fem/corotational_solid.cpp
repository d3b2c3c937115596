#include "corotational_solid.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

#include <pleura/nodes/deformable/fem/rotation.h>

namespace pleura {
namespace {

constexpr std::size_t kMostNodes = 8;
constexpr std::size_t kMostPoints = 8;

}  // namespace

CorotationalSolid::CorotationalSolid(const SolidMesh& mesh, const SolidMaterial& material,
                                     const SolidConstraints& constraints, const CorotationalOptions& options)
    : NewtonSolid(makeSolidBody(mesh, material, constraints), options),
      _options(options),
      _rotation(_body.elements.weight.size(), Eigen::Matrix3d::Identity()),
      _nodeRotation(_body.rest.size(), Eigen::Matrix3d::Identity()),
      _factor(_body.pattern, _body.unknowns) {
  if (options.linearIterations < 1 || !std::isfinite(options.linearTolerance) || options.linearTolerance <= 0)
    throw std::invalid_argument(
        "solid: linear iterations below 1, or a linear tolerance that is not positive");
  for (NodeVectors* x : {&_r, &_z, &_p, &_Ap}) x->assign(_body.rest.size(), Eigen::Vector3d::Zero());
  start();
}

double CorotationalSolid::evaluate(const NodeVectors& x, NodeVectors& forces) {
  const SolidElements& elements = _body.elements;
  const auto [lambda, mu] = _body.lame;
  const int n = elements.nodesPerElement, points = elements.pointsPerElement;
  std::fill(forces.begin(), forces.end(), Eigen::Vector3d::Zero());
  std::array<Eigen::Matrix3d, kMostPoints> stretch;  // F - R
  std::array<double, kMostPoints> theta;
  double energy = 0;
  for (int e = 0; e < elements.count(); ++e) {
    const int* node = elements.nodesOf(e);
    double volume = 0, mean = 0;
    for (int k = 0; k < points; ++k) {
      const int q = e * points + k;
      const Eigen::Vector3d* g = elements.gradientsAt(q);
      Eigen::Matrix3d F = Eigen::Matrix3d::Zero();
      for (int a = 1; a < n; ++a) F += (x[node[a]] - x[node[0]]) * g[a].transpose();
      const Eigen::Matrix3d R = nearestRotation(F);
      const double w = elements.weight[q];
      stretch[k] = F - R;
      theta[k] = R.cwiseProduct(stretch[k]).sum();
      volume += w;
      mean += w * theta[k];
      energy += w * mu * (stretch[k].squaredNorm() - theta[k] * theta[k] / 3);
      _rotation[q] = R;
    }
    mean /= volume;
    energy += volume * (0.5 * lambda + mu / 3) * mean * mean;
    for (int k = 0; k < points; ++k) {
      const int q = e * points + k;
      const Eigen::Vector3d* g = elements.gradientsAt(q);
      const double pressure = (lambda + 2. / 3 * mu) * mean - 2. / 3 * mu * theta[k];
      const Eigen::Matrix3d P = elements.weight[q] * (2 * mu * stretch[k] + pressure * _rotation[q]);
      for (int a = 0; a < n; ++a) forces[node[a]] -= P * g[a];
    }
  }
  return energy;
}

void CorotationalSolid::assemble(BlockValues& K) {
  const SolidElements& elements = _body.elements;
  const int n = elements.nodesPerElement, points = elements.pointsPerElement;
  std::fill(_nodeRotation.begin(), _nodeRotation.end(), Eigen::Matrix3d::Zero());
  std::array<std::array<Eigen::Vector3d, kMostNodes>, kMostPoints> turned;
  std::array<Eigen::Vector3d, kMostNodes> mean;
  for (int e = 0; e < elements.count(); ++e) {
    const int* node = elements.nodesOf(e);
    mean.fill(Eigen::Vector3d::Zero());
    double volume = 0;
    for (int k = 0; k < points; ++k) {
      const int q = e * points + k;
      const double w = elements.weight[q];
      volume += w;
      for (int a = 0; a < n; ++a) {
        turned[k][a] = _rotation[q] * elements.gradientsAt(q)[a];
        mean[a] += w * turned[k][a];
        _nodeRotation[node[a]] += w * _rotation[q];
      }
    }
    for (int a = 0; a < n; ++a) mean[a] /= volume;
    const int* slot = &_body.elementSlots[e * n * (n + 1) / 2];
    for (int k = 0; k < points; ++k) {
      const double w = elements.weight[e * points + k];
      const int* next = slot;
      for (int a = 0; a < n; ++a)
        for (int b = a; b < n; ++b)
          addBlock(K, *next++, stiffnessBlock(_body.lame, w, turned[k][a], turned[k][b], mean[a], mean[b]));
    }
  }
  for (auto& R : _nodeRotation) R = nearestRotation(R);
  // Springs hold places, not turned ones: turned, their stiff part of the factor would fit none.
  for (const int node : _body.constraints.soft.node) _nodeRotation[node].setIdentity();
}

bool CorotationalSolid::prepare(double h) {
  // The tangent at rest, whose rotations are none; those of the state come back after.
  BlockValues tangent(_body.pattern.slotCount(), Eigen::Matrix3d::Zero());
  auto rotation = std::vector<Eigen::Matrix3d>(_rotation.size(), Eigen::Matrix3d::Identity());
  std::swap(rotation, _rotation);
  assemble(tangent);
  std::swap(rotation, _rotation);
  addSoftStiffness(_body, tangent);
  for (auto& block : tangent) block *= 1 + _body.stiffnessDamping / h;
  for (std::size_t i = 0; i < _body.mass.size(); ++i)
    tangent[_body.pattern.begin[i]].diagonal().array() += (1 / h + _body.massDamping) / h * _body.mass[i];
  return _factor.factorise(_body.pattern, tangent);
}

void CorotationalSolid::precondition(const NodeVectors& r, NodeVectors& z) {
  for (std::size_t i = 0; i < r.size(); ++i) z[i] = _nodeRotation[i].transpose() * r[i];
  _factor.solve(z, z);
  for (auto i : _body.unknowns) z[i] = _nodeRotation[i] * z[i];
}

bool CorotationalSolid::solve(const BlockValues& A, const NodeVectors& b, NodeVectors& d, int& iterations) {
  std::fill(d.begin(), d.end(), Eigen::Vector3d::Zero());
  for (std::size_t i = 0; i < b.size(); ++i) _r[i] = _body.isUnknown[i] ? b[i] : Eigen::Vector3d::Zero();
  const double enough = _options.linearTolerance * flat(_r).norm();
  if (enough <= 0) return true;
  precondition(_r, _z);
  std::copy(_z.begin(), _z.end(), _p.begin());
  double rz = flat(_r).dot(flat(_z));
  for (int i = 0; i < _options.linearIterations; ++i) {
    multiply(_body.pattern, A, _p, _Ap);
    for (const auto& c : _body.couplings) _Ap[c.fixed].setZero();
    ++iterations;
    const double curvature = flat(_p).dot(flat(_Ap));
    if (curvature <= 0) break;  // rounding, the tangent being semidefinite
    const double step = rz / curvature;
    flat(d) += step * flat(_p);
    flat(_r) -= step * flat(_Ap);
    if (flat(_r).norm() <= enough) break;
    precondition(_r, _z);
    const double before = rz;
    rz = flat(_r).dot(flat(_z));
    flat(_p) = flat(_z) + rz / before * flat(_p);
  }
  return flat(d).cwiseAbs().maxCoeff() > 0;
}

}  // namespace pleura
