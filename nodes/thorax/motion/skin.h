#pragma once

#include <Eigen/Geometry>
#include <array>
#include <span>
#include <vector>

namespace pleura {

/// Which bodies carry a point, and by how much. Weights sum to at most one; what is missing stays where it was.
struct BodyWeights {
  static constexpr int kMax = 5;
  std::array<int, kMax> body{};  // indices into the bodies' motions
  std::array<double, kMax> weight{};
  int count = 0;

  /// Adds `w` of body `index`, merged with what is there. Throws std::invalid_argument beyond kMax bodies.
  void add(int index, double w);
};

/// The whole weight on one body.
BodyWeights rigidWith(int body);

/// (1 - t) a + t b.
BodyWeights mix(const BodyWeights& a, const BodyWeights& b, double t);

/// A point carried by a blend of rigid motions (linear blend skinning): p' = p + sum_k w_k (M_k p - p).
inline Eigen::Vector3d carry(const Eigen::Vector3d& p, const BodyWeights& weights,
                             std::span<const Eigen::Isometry3d> motions) {
  Eigen::Vector3d moved = p;
  for (int k = 0; k < weights.count; ++k) {
    const Eigen::Isometry3d& m = motions[static_cast<std::size_t>(weights.body[static_cast<std::size_t>(k)])];
    moved += weights.weight[static_cast<std::size_t>(k)] * (m.linear() * p + m.translation() - p);
  }
  return moved;
}

}  // namespace pleura
