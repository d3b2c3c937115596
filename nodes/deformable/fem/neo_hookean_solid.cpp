#include <algorithm>
#include <array>
#include <cmath>

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <Eigen/SVD>

#include <pleura/nodes/deformable/fem/neo_hookean_solid.h>
#include <pleura/nodes/deformable/fem/rotation.h>

namespace pleura {
namespace {

double determinant(const Eigen::Matrix3d& F) { return F.col(0).dot(F.col(1).cross(F.col(2))); }

// An eigenvalue of d2E/dF2 and its matrix, of norm 1.
struct Mode {
  double value;
  Eigen::Matrix3d shape;
};

// The nine of E = a(I) + b(J), from a' = da/dI, a'', b' and b'': with F = U diag(s) V^T and (i, j, k) cyclic,
// 2 a' + b' s_k on the twists and 2 a' - b' s_k on the flips of i and j, and those of
// 4 a'' s s^T + 2 a' 1 + b'' c c^T + b' (s_k off the diagonal), c = (s_j s_k), on the stretches.
std::array<Mode, 9> modesOf(const Eigen::Matrix3d& F, double da, double dda, double db, double ddb) {
  const Eigen::JacobiSVD<Eigen::Matrix3d> svd(F, Eigen::ComputeFullU | Eigen::ComputeFullV);
  Eigen::Matrix3d U = svd.matrixU();
  const Eigen::Matrix3d& V = svd.matrixV();
  Eigen::Vector3d s = svd.singularValues();
  if (determinant(U) * determinant(V) < 0) {  // so that the product of s is J
    U.col(2) = -U.col(2);
    s[2] = -s[2];
  }
  const Eigen::Vector3d c(s[1] * s[2], s[2] * s[0], s[0] * s[1]);
  Eigen::Matrix3d stretch = 4 * dda * s * s.transpose() + ddb * c * c.transpose();
  stretch.diagonal().array() += 2 * da;
  std::array<Mode, 9> modes;
  for (int k = 0; k < 3; ++k) {
    const int i = (k + 1) % 3, j = (k + 2) % 3;
    stretch(i, j) += db * s[k];
    stretch(j, i) += db * s[k];
    const Eigen::Matrix3d ij = U.col(i) * V.col(j).transpose(), ji = U.col(j) * V.col(i).transpose();
    modes[k] = {2 * da + db * s[k], std::sqrt(0.5) * (ij - ji)};
    modes[3 + k] = {2 * da - db * s[k], std::sqrt(0.5) * (ij + ji)};
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> eigen(stretch);
  for (int k = 0; k < 3; ++k)
    modes[6 + k] = {eigen.eigenvalues()[k], U * eigen.eigenvectors().col(k).asDiagonal() * V.transpose()};
  return modes;
}

}  // namespace

NeoHookeanSolid::NeoHookeanSolid(const SolidMesh& mesh, const SolidMaterial& material,
                                 const SolidConstraints& constraints, const NewtonOptions& options)
    : NewtonSolid(makeSolidBody(mesh, material, constraints), options),
      F_(body_.elements.weight.size(), Eigen::Matrix3d::Identity()),
      meanJacobian_(body_.elements.count(), 1),
      factor_(body_.pattern, body_.unknowns) {
  start();
}

double NeoHookeanSolid::evaluate(const NodeVectors& x, NodeVectors& forces) {
  const SolidElements& elements = body_.elements;
  const auto [lambda, mu] = body_.lame;
  const double kappa = lambda + 2. / 3 * mu;
  const int n = elements.nodesPerElement, points = elements.pointsPerElement;
  std::fill(forces.begin(), forces.end(), Eigen::Vector3d::Zero());
  double energy = 0;
  for (int e = 0; e < elements.count(); ++e) {
    const int* node = elements.nodesOf(e);
    double volume = 0, mean = 0;
    for (int q = e * points; q < (e + 1) * points; ++q) {
      const Eigen::Vector3d* g = elements.gradientsAt(q);
      Eigen::Matrix3d& F = F_[q];
      F.setZero();
      for (int a = 1; a < n; ++a) F += (x[node[a]] - x[node[0]]) * g[a].transpose();
      volume += elements.weight[q];
      mean += elements.weight[q] * determinant(F);
    }
    mean /= volume;
    meanJacobian_[e] = mean;
    energy += volume * 0.5 * kappa * (mean - 1) * (mean - 1);
    for (int q = e * points; q < (e + 1) * points; ++q) {
      const Eigen::Vector3d* g = elements.gradientsAt(q);
      const Eigen::Matrix3d& F = F_[q];
      const double w = elements.weight[q], I = F.squaredNorm(), J = determinant(F);
      energy += w * mu * (2. / 3 * (I - 3 - std::log((I + 1) / 4)) - (J - 1) + (J - 1) * (J - 1) / 12);
      const Eigen::Matrix3d P =
          w * (4. / 3 * mu * (I / (I + 1)) * F + (mu * ((J - 1) / 6 - 1) + kappa * (mean - 1)) * cofactor(F));
      for (int a = 0; a < n; ++a) forces[node[a]] -= P * g[a];
    }
  }
  return energy;
}

void NeoHookeanSolid::assemble(BlockValues& K) {
  const SolidElements& elements = body_.elements;
  const auto [lambda, mu] = body_.lame;
  const double kappa = lambda + 2. / 3 * mu;
  const int n = elements.nodesPerElement, points = elements.pointsPerElement;
  std::array<Eigen::Vector3d, kMostElementNodes> row;
  std::array<Eigen::Vector3d, kMostElementNodes> mean;  // dm/dx_a, times the volume
  for (int e = 0; e < elements.count(); ++e) {
    const int* slots = &body_.elementSlots[e * n * (n + 1) / 2];
    const auto addOuter = [&](double scale, const std::array<Eigen::Vector3d, kMostElementNodes>& v) {
      const int* slot = slots;
      for (int a = 0; a < n; ++a)
        for (int b = a; b < n; ++b) addBlock(K, *slot++, scale * v[a] * v[b].transpose());
    };
    mean.fill(Eigen::Vector3d::Zero());
    double volume = 0;
    for (int q = e * points; q < (e + 1) * points; ++q) {
      const Eigen::Vector3d* g = elements.gradientsAt(q);
      const Eigen::Matrix3d& F = F_[q];
      const double w = elements.weight[q], I = F.squaredNorm(), J = determinant(F);
      const double da = 2. / 3 * mu * (I / (I + 1)), dda = 2. / 3 * mu / ((I + 1) * (I + 1));
      const double db = mu * ((J - 1) / 6 - 1) + kappa * (meanJacobian_[e] - 1), ddb = mu / 6;
      for (const Mode& mode : modesOf(F, da, dda, db, ddb)) {
        if (mode.value <= 0) continue;
        for (int a = 0; a < n; ++a) row[a] = mode.shape * g[a];
        addOuter(w * mode.value, row);
      }
      const Eigen::Matrix3d c = cofactor(F);
      for (int a = 0; a < n; ++a) mean[a] += w * (c * g[a]);
      volume += w;
    }
    addOuter(kappa / volume, mean);
  }
}

bool NeoHookeanSolid::solve(const BlockValues& A, const NodeVectors& b, NodeVectors& d, int& iterations) {
  ++iterations;
  if (!factor_.factorise(body_.pattern, A)) return false;
  factor_.solve(b, d);
  return true;
}

}  // namespace pleura
