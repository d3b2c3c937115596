#include <algorithm>
#include <stdexcept>

#include <Eigen/Dense>

#include <pleura/nodes/thorax/anatomy/spline.h>

namespace pleura {
namespace {

using Eigen::Vector3d;

constexpr int kSteps = 512;

void checkKnots(const std::vector<double>& knots, std::size_t points) {
  if (knots.size() < 2 || knots.size() != points)
    throw std::invalid_argument("spline: knots: fewer than two");
  for (std::size_t i = 1; i < knots.size(); ++i) {
    if (!(knots[i - 1] < knots[i])) throw std::invalid_argument("spline: knots: not strictly increasing");
  }
}

// h0 M0 + 2 (h0 + h1) M1 + h1 M2 = 6 (d1 - d0) inside, M = 0 at both ends.
std::vector<Vector3d> curvatureOf(const std::vector<double>& x, const std::vector<Vector3d>& y) {
  const Eigen::Index n = static_cast<Eigen::Index>(x.size());
  Eigen::MatrixXd system = Eigen::MatrixXd::Identity(n, n);
  Eigen::MatrixX3d right = Eigen::MatrixX3d::Zero(n, 3);
  for (Eigen::Index i = 1; i + 1 < n; ++i) {
    const double h0 = x[i] - x[i - 1];
    const double h1 = x[i + 1] - x[i];
    system.row(i).segment<3>(i - 1) << h0, 2.0 * (h0 + h1), h1;
    right.row(i) = 6.0 * ((y[i + 1] - y[i]) / h1 - (y[i] - y[i - 1]) / h0);
  }
  const Eigen::MatrixX3d solution = system.partialPivLu().solve(right);
  std::vector<Vector3d> curvature(x.size());
  for (Eigen::Index i = 0; i < n; ++i) curvature[i] = solution.row(i);
  return curvature;
}

}  // namespace

Spline::Spline(std::vector<double> knots, std::vector<Vector3d> points)
    : knots_(std::move(knots)), points_(std::move(points)) {
  checkKnots(knots_, points_.size());
  curvature_ = curvatureOf(knots_, points_);
}

Spline::Place Spline::place(double at) const {
  const auto after = std::upper_bound(knots_.begin() + 1, knots_.end() - 1, at);
  const double t = std::clamp((at - *(after - 1)) / (*after - *(after - 1)), 0.0, 1.0);
  return {static_cast<std::size_t>(after - knots_.begin()) - 1, 1.0 - t, t};
}

Vector3d Spline::at(double parameter) const {
  const auto [i, u, t] = place(parameter);
  const double h = knots_[i + 1] - knots_[i];
  return u * points_[i] + t * points_[i + 1] +
         (h * h / 6.0) * ((u * u * u - u) * curvature_[i] + (t * t * t - t) * curvature_[i + 1]);
}

Vector3d Spline::derivative(double parameter) const {
  const auto [i, u, t] = place(parameter);
  const double h = knots_[i + 1] - knots_[i];
  return (points_[i + 1] - points_[i]) / h +
         (h / 6.0) * ((1.0 - 3.0 * u * u) * curvature_[i] + (3.0 * t * t - 1.0) * curvature_[i + 1]);
}

ArcLength::ArcLength(const Spline& spline) : begin_(spline.begin()), end_(spline.end()), lengths_{0.0} {
  Vector3d last = spline.at(begin_);
  for (int k = 1; k <= kSteps; ++k) {
    const Vector3d next = spline.at(begin_ + (end_ - begin_) * k / kSteps);
    lengths_.push_back(lengths_.back() + (next - last).norm());
    last = next;
  }
}

double ArcLength::parameter(double length) const {
  const auto after = std::upper_bound(lengths_.begin() + 1, lengths_.end() - 1, length);
  const double step = std::max(*after - *(after - 1), 1e-12);
  const double t = std::clamp((length - *(after - 1)) / step, 0.0, 1.0);
  return begin_ + (end_ - begin_) * (static_cast<double>(after - lengths_.begin()) - 1.0 + t) / kSteps;
}

double ArcLength::lengthAt(double parameter) const {
  const double at = std::clamp((parameter - begin_) / (end_ - begin_), 0.0, 1.0) * kSteps;
  const int k = std::min(static_cast<int>(at), kSteps - 1);
  return lengths_[k] + (at - k) * (lengths_[k + 1] - lengths_[k]);
}

}  // namespace pleura
