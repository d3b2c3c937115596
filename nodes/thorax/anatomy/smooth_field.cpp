#include <algorithm>
#include <stdexcept>

#include <pleura/nodes/thorax/anatomy/smooth_field.h>

namespace pleura {
namespace {

// The uniform cubic B-spline's weights of the nodes -1, 0, 1, 2 at t in [0, 1].
Eigen::Vector4d weightsAt(double t) {
  const double u = 1.0 - t;
  return Eigen::Vector4d(u * u * u, 3.0 * t * t * t - 6.0 * t * t + 4.0, 3.0 * u * u * u - 6.0 * u * u + 4.0,
                         t * t * t) /
         6.0;
}

}  // namespace

SmoothField::SmoothField(const Solid& function, const Eigen::AlignedBox3d& box, double spacing)
    : origin_(box.min()), spacing_(spacing) {
  if (!(spacing > 0.0)) throw std::invalid_argument("SmoothField: spacing: not positive");
  nodes_ = (box.sizes() / spacing).array().ceil().cast<int>() + 1;
  values_.reserve(static_cast<std::size_t>(nodes_.prod()));
  for (int k = 0; k < nodes_.z(); ++k) {
    for (int j = 0; j < nodes_.y(); ++j) {
      for (int i = 0; i < nodes_.x(); ++i)
        values_.push_back(function(origin_ + spacing * Eigen::Vector3d(i, j, k)));
    }
  }
}

double SmoothField::operator()(const Eigen::Vector3d& point) const {
  const Eigen::Vector3d at = (point - origin_) / spacing_;
  const Eigen::Vector3d floor = at.array().floor();
  Eigen::Matrix<int, 4, 3> node;
  Eigen::Matrix<double, 4, 3> weight;
  for (int axis = 0; axis < 3; ++axis) {
    weight.col(axis) = weightsAt(at[axis] - floor[axis]);
    for (int k = 0; k < 4; ++k) {
      node(k, axis) = std::clamp(static_cast<int>(floor[axis]) + k - 1, 0, nodes_[axis] - 1);
    }
  }
  double sum = 0.0;
  for (int k = 0; k < 4; ++k) {
    for (int j = 0; j < 4; ++j) {
      const std::size_t rowsBefore = static_cast<std::size_t>(node(k, 2)) * nodes_.y() + node(j, 1);
      const double* row = &values_[rowsBefore * nodes_.x()];
      double line = 0.0;
      for (int i = 0; i < 4; ++i) line += weight(i, 0) * row[node(i, 0)];
      sum += weight(j, 1) * weight(k, 2) * line;
    }
  }
  return sum;
}

}  // namespace pleura
