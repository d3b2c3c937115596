#pragma once

#include <vector>

#include <Eigen/Core>

namespace pleura {

/// Natural cubic spline through points in space (de Boor 1978, ch. IV).
class Spline {
 public:
  /// At least two knots, strictly increasing, one point each; throws std::invalid_argument otherwise.
  Spline(std::vector<double> knots, std::vector<Eigen::Vector3d> points);

  double begin() const { return knots_.front(); }
  double end() const { return knots_.back(); }

  /// Point and first derivative at t, clamped to [begin, end].
  Eigen::Vector3d at(double t) const;
  Eigen::Vector3d derivative(double t) const;

 private:
  struct Place {
    std::size_t interval;
    double u, t;  // weights of its first and second knot
  };
  Place place(double t) const;

  std::vector<double> knots_;
  std::vector<Eigen::Vector3d> points_;
  std::vector<Eigen::Vector3d> curvature_;  // second derivatives at the knots
};

/// The distance along a curve: a spline read by arc length [m] instead of by its parameter.
class ArcLength {
 public:
  explicit ArcLength(const Spline& spline);

  double length() const { return lengths_.back(); }  // [m]
  /// The spline's parameter at a length from its begin, clamped.
  double parameter(double length) const;
  /// The length from the begin to a parameter of the spline.
  double lengthAt(double parameter) const;

 private:
  double begin_, end_;
  std::vector<double> lengths_;  // at equal steps of the parameter
};

}  // namespace pleura
