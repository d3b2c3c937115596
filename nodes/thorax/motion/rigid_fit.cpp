#include <stdexcept>

#include <Eigen/SVD>

#include <pleura/nodes/thorax/motion/rigid_fit.h>

namespace pleura {
namespace {

Eigen::Vector3d mean(std::span<const Eigen::Vector3d> points) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (const Eigen::Vector3d& point : points) sum += point;
  return sum / static_cast<double>(points.size());
}

}  // namespace

Eigen::Isometry3d fitRigid(std::span<const Eigen::Vector3d> from, std::span<const Eigen::Vector3d> to) {
  if (from.empty() || from.size() != to.size()) {
    throw std::invalid_argument("fitRigid: from and to must have the same number of points, at least one");
  }
  const Eigen::Vector3d a = mean(from);
  const Eigen::Vector3d b = mean(to);
  if (!a.array().isFinite().all() || !b.array().isFinite().all())
    throw std::invalid_argument("fitRigid: points must be finite");

  // C = sum (b_i - b)(a_i - a)^T = U S V^T; R = U diag(1, 1, det(U V^T)) V^T; t = b - R a
  Eigen::Matrix3d c = Eigen::Matrix3d::Zero();
  for (std::size_t i = 0; i < from.size(); ++i) c += (to[i] - b) * (from[i] - a).transpose();
  const Eigen::JacobiSVD<Eigen::Matrix3d> svd(c, Eigen::ComputeFullU | Eigen::ComputeFullV);
  const double det = (svd.matrixU() * svd.matrixV().transpose()).determinant();
  const Eigen::Vector3d s(1.0, 1.0, det < 0.0 ? -1.0 : 1.0);

  Eigen::Isometry3d motion = Eigen::Isometry3d::Identity();
  motion.linear() = svd.matrixU() * s.asDiagonal() * svd.matrixV().transpose();
  motion.translation() = b - motion.linear() * a;
  return motion;
}

}  // namespace pleura
