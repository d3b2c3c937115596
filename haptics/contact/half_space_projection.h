#pragma once

#include <array>
#include <span>

#include <Eigen/Core>

namespace pleura::haptics {

/// The point of an intersection of half-spaces normal . x >= offset that is nearest to a target: the
/// half-spaces are added one after the other (dual active-set method, Goldfarb and Idnani 1983).
class HalfSpaceProjection {
 public:
  /// A half-space on whose plane the point lies: point - target = sum depth * normal, depth >= 0.
  struct Active {
    int label;
    Eigen::Vector3d normal;
    double depth;
  };

  explicit HalfSpaceProjection(const Eigen::Vector3d& target) : point_(target) {}

  /// Adds a half-space that the point is outside of; its normal is a unit vector. False: the intersection is
  /// empty, and the point means nothing any more.
  bool add(int label, const Eigen::Vector3d& normal, double offset);

  const Eigen::Vector3d& point() const { return point_; }
  /// Lives as long as the projection does.
  std::span<const Active> active() const& { return {active_.data(), static_cast<std::size_t>(count_)}; }
  void active() const&& = delete;

 private:
  /// normal = sum along[j] * active normal j + the returned vector, which is orthogonal to all of them.
  Eigen::Vector3d decompose(const Eigen::Vector3d& normal, Eigen::Vector3d& along) const;

  Eigen::Vector3d point_;
  std::array<Active, 3> active_;
  int count_ = 0;
};

}  // namespace pleura::haptics
