#include <algorithm>
#include <limits>

#include <pleura/haptics/contact/half_space_projection.h>

namespace pleura::haptics {

using Eigen::Vector3d;

namespace {

/// The sine squared below which a normal counts as a combination of others.
constexpr double kDependent = 1e-12;

/// The share of another normal above which it is one.
constexpr double kShare = 1e-12;

}  // namespace

Vector3d HalfSpaceProjection::decompose(const Vector3d& normal, Vector3d& along) const {
  // Gram-Schmidt: active normal j = sum over i <= j of triangle(i, j) * basis i
  Eigen::Matrix3d basis, triangle;
  Vector3d rest = normal, shares = Vector3d::Zero();
  for (int j = 0; j < count_; ++j) {
    Vector3d own = active_[j].normal;
    for (int i = 0; i < j; ++i) {
      triangle(i, j) = basis.col(i).dot(own);
      own -= triangle(i, j) * basis.col(i);
    }
    triangle(j, j) = own.norm();
    basis.col(j) = own / triangle(j, j);
    shares[j] = basis.col(j).dot(rest);
    rest -= shares[j] * basis.col(j);
  }
  for (int j = count_ - 1; j >= 0; --j) {
    along[j] = shares[j];
    for (int i = j + 1; i < count_; ++i) along[j] -= triangle(j, i) * along[i];
    along[j] /= triangle(j, j);
  }
  return rest;
}

bool HalfSpaceProjection::add(int label, const Vector3d& normal, double offset) {
  constexpr double never = std::numeric_limits<double>::max();
  double depth = 0;
  while (true) {
    Vector3d along;
    const Vector3d across = decompose(normal, along);
    // how far until the half-space is reached, and until an active one lets go
    const double squared = across.squaredNorm();
    const double reached = squared > kDependent ? (offset - normal.dot(point_)) / squared : never;
    double released = never;
    int leaving = -1;
    for (int j = 0; j < count_; ++j) {
      if (along[j] <= kShare || active_[j].depth / along[j] >= released) continue;
      released = active_[j].depth / along[j];
      leaving = j;
    }
    const double step = std::min(reached, released);
    if (step == never) return false;
    depth += step;
    for (int j = 0; j < count_; ++j) active_[j].depth = std::max(0.0, active_[j].depth - step * along[j]);
    if (reached < never) point_ += step * across;
    if (reached <= released) {
      active_[count_++] = {label, normal, depth};
      return true;
    }
    std::copy(active_.begin() + leaving + 1, active_.begin() + count_, active_.begin() + leaving);
    --count_;
  }
}

}  // namespace pleura::haptics
