#include <cmath>

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>

#include <pleura/nodes/deformable/fem/rotation.h>

namespace pleura {
namespace {

constexpr int kMostSteps = 12;

// As a quaternion: the greatest eigenvector of Horn's (1987) matrix.
Eigen::Matrix3d nearestRotationByEigenvector(const Eigen::Matrix3d& F) {
  const double size = F.cwiseAbs().maxCoeff();
  if (size < 1e-60) return Eigen::Matrix3d::Identity();
  const Eigen::Matrix3d f = F / size;
  Eigen::Matrix4d N;
  N << f.trace(), f(2, 1) - f(1, 2), f(0, 2) - f(2, 0), f(1, 0) - f(0, 1),   //
      0, f(0, 0) - f(1, 1) - f(2, 2), f(0, 1) + f(1, 0), f(2, 0) + f(0, 2),  //
      0, 0, f(1, 1) - f(0, 0) - f(2, 2), f(1, 2) + f(2, 1),                  //
      0, 0, 0, f(2, 2) - f(0, 0) - f(1, 1);
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix4d> eigen(N.transpose());  // reads the lower triangle
  const Eigen::Vector4d q = eigen.eigenvectors().col(3);
  return Eigen::Quaterniond(q[0], q[1], q[2], q[3]).normalized().toRotationMatrix();
}

}  // namespace

Eigen::Matrix3d nearestRotation(const Eigen::Matrix3d& F) {
  // Higham's (1986) Newton steps R := (R + R^-T) / 2, for what is neither nearly flat nor mirrored.
  Eigen::Matrix3d c = cofactor(F);
  double det = F.col(0).dot(c.col(0));
  const double norm = F.squaredNorm();
  if (norm < 1e-60 || det <= 1e-3 * norm * std::sqrt(norm)) return nearestRotationByEigenvector(F);
  const double scale = 1 / std::cbrt(det);
  Eigen::Matrix3d R = 0.5 * (scale * F + scale * scale * c);
  for (int i = 0; i < kMostSteps; ++i) {
    c = cofactor(R);
    det = R.col(0).dot(c.col(0));
    const Eigen::Matrix3d next = 0.5 * (R + c / det);
    const double change = (next - R).squaredNorm();
    R = next;
    if (change < 1e-18) break;  // the next one would be within 1e-18, the convergence being quadratic
  }
  return R;
}

}  // namespace pleura
