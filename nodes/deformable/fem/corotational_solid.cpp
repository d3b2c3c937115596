#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

#include <pleura/nodes/deformable/fem/corotational_solid.h>
#include <pleura/nodes/deformable/fem/rotation.h>

namespace pleura {

CorotationalSolid::CorotationalSolid(const SolidMesh& mesh, const SolidMaterial& material,
                                     const SolidConstraints& constraints, const CorotationalOptions& options)
    : NewtonSolid(makeSolidBody(mesh, material, constraints), options),
      options_(options),
      rotation_(body_.elements.weight.size(), Eigen::Matrix3d::Identity()),
      nodeRotation_(body_.rest.size(), Eigen::Matrix3d::Identity()),
      factor_(body_.pattern, body_.unknowns) {
  if (options.linearIterations < 1 || !std::isfinite(options.linearTolerance) || options.linearTolerance <= 0)
    throw std::invalid_argument(
        "solid: linear iterations below 1, or a linear tolerance that is not positive");
  for (NodeVectors* x : {&r_, &z_, &p_, &Ap_}) x->assign(body_.rest.size(), Eigen::Vector3d::Zero());
  start();
}

double CorotationalSolid::evaluate(const NodeVectors& x, NodeVectors& forces) {
  const SolidElements& elements = body_.elements;
  const auto [lambda, mu] = body_.lame;
  const int n = elements.nodesPerElement, points = elements.pointsPerElement;
  std::fill(forces.begin(), forces.end(), Eigen::Vector3d::Zero());
  std::array<Eigen::Matrix3d, kMostElementPoints> stretch;  // F - R
  std::array<double, kMostElementPoints> theta;
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
      rotation_[q] = R;
    }
    mean /= volume;
    energy += volume * (0.5 * lambda + mu / 3) * mean * mean;
    for (int k = 0; k < points; ++k) {
      const int q = e * points + k;
      const Eigen::Vector3d* g = elements.gradientsAt(q);
      const double pressure = (lambda + 2. / 3 * mu) * mean - 2. / 3 * mu * theta[k];
      const Eigen::Matrix3d P = elements.weight[q] * (2 * mu * stretch[k] + pressure * rotation_[q]);
      for (int a = 0; a < n; ++a) forces[node[a]] -= P * g[a];
    }
  }
  return energy;
}

void CorotationalSolid::assemble(BlockValues& K) {
  const SolidElements& elements = body_.elements;
  const int n = elements.nodesPerElement, points = elements.pointsPerElement;
  std::fill(nodeRotation_.begin(), nodeRotation_.end(), Eigen::Matrix3d::Zero());
  std::array<std::array<Eigen::Vector3d, kMostElementNodes>, kMostElementPoints> turned;
  std::array<Eigen::Vector3d, kMostElementNodes> mean;
  for (int e = 0; e < elements.count(); ++e) {
    const int* node = elements.nodesOf(e);
    mean.fill(Eigen::Vector3d::Zero());
    double volume = 0;
    for (int k = 0; k < points; ++k) {
      const int q = e * points + k;
      const double w = elements.weight[q];
      volume += w;
      for (int a = 0; a < n; ++a) {
        turned[k][a] = rotation_[q] * elements.gradientsAt(q)[a];
        mean[a] += w * turned[k][a];
        nodeRotation_[node[a]] += w * rotation_[q];
      }
    }
    for (int a = 0; a < n; ++a) mean[a] /= volume;
    const int* slot = &body_.elementSlots[e * n * (n + 1) / 2];
    for (int k = 0; k < points; ++k) {
      const double w = elements.weight[e * points + k];
      const int* next = slot;
      for (int a = 0; a < n; ++a)
        for (int b = a; b < n; ++b)
          addBlock(K, *next++, stiffnessBlock(body_.lame, w, turned[k][a], turned[k][b], mean[a], mean[b]));
    }
  }
  for (auto& R : nodeRotation_) R = nearestRotation(R);
  // Springs hold places, not turned ones: turned, their stiff part of the factor would fit none.
  for (const int node : body_.constraints.soft.node) nodeRotation_[node].setIdentity();
}

bool CorotationalSolid::prepare(double h) {
  // The tangent at rest, whose rotations are none; those of the state come back after.
  BlockValues tangent(body_.pattern.slotCount(), Eigen::Matrix3d::Zero());
  auto rotation = std::vector<Eigen::Matrix3d>(rotation_.size(), Eigen::Matrix3d::Identity());
  std::swap(rotation, rotation_);
  assemble(tangent);
  std::swap(rotation, rotation_);
  addSoftStiffness(body_, tangent);
  for (auto& block : tangent) block *= 1 + body_.stiffnessDamping / h;
  addInertia(body_, 1 / h, tangent);
  return factor_.factorise(body_.pattern, tangent);
}

void CorotationalSolid::precondition(const NodeVectors& r, NodeVectors& z) {
  for (std::size_t i = 0; i < r.size(); ++i) z[i] = nodeRotation_[i].transpose() * r[i];
  factor_.solve(z, z);
  for (auto i : body_.unknowns) z[i] = nodeRotation_[i] * z[i];
}

bool CorotationalSolid::solve(const BlockValues& A, const NodeVectors& b, NodeVectors& d, int& iterations) {
  std::fill(d.begin(), d.end(), Eigen::Vector3d::Zero());
  for (std::size_t i = 0; i < b.size(); ++i) r_[i] = body_.isUnknown[i] ? b[i] : Eigen::Vector3d::Zero();
  const double enough = options_.linearTolerance * flat(r_).norm();
  if (enough <= 0) return true;
  precondition(r_, z_);
  std::copy(z_.begin(), z_.end(), p_.begin());
  double rz = flat(r_).dot(flat(z_));
  for (int i = 0; i < options_.linearIterations; ++i) {
    multiply(body_.pattern, A, p_, Ap_);
    for (const auto& c : body_.couplings) Ap_[c.fixed].setZero();
    ++iterations;
    const double curvature = flat(p_).dot(flat(Ap_));
    if (curvature <= 0) break;  // rounding, the tangent being semidefinite
    const double step = rz / curvature;
    flat(d) += step * flat(p_);
    flat(r_) -= step * flat(Ap_);
    if (flat(r_).norm() <= enough) break;
    precondition(r_, z_);
    const double before = rz;
    rz = flat(r_).dot(flat(z_));
    flat(p_) = flat(z_) + rz / before * flat(p_);
  }
  return flat(d).cwiseAbs().maxCoeff() > 0;
}

}  // namespace pleura
