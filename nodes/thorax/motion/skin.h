#pragma once

#include <array>
#include <cstdint>
#include <span>

#include <Eigen/Geometry>

namespace pleura {

/// Which bodies carry a point, and by how much. What the weights lack of one stays where it was.
struct BodyWeights {
  static constexpr int kMax = 5;
  std::array<float, kMax> weight{};
  std::array<std::uint8_t, kMax> body{};  // indices into the bodies' displacements
  std::uint8_t count = 0;

  /// Adds weight `w` of body `index`. Throws std::invalid_argument beyond kMax bodies or 255.
  void add(int index, double w);
};

/// The whole weight on one body.
BodyWeights rigidWith(int body);

/// (1 - t) a + t b.
BodyWeights mix(const BodyWeights& a, const BodyWeights& b, double t);

/// A rigid motion as what it adds to a point (x, y, z, 1) [m]: D = [R - I, t; 0]. Zero at rest, so that
/// floats keep the rest shape to the last bit.
using BodyDisplacement = Eigen::Matrix4f;

BodyDisplacement displacementOf(const Eigen::Isometry3d& motion);

/// A point (x, y, z, 1) carried by a blend of rigid motions (linear blend skinning): p' = p + sum_k w_k D_k
/// p.
inline Eigen::Vector4f carry(const Eigen::Vector4f& p, const BodyWeights& weights,
                             std::span<const BodyDisplacement> displacements) {
  Eigen::Vector4f moved = p;
  for (std::size_t k = 0; k < weights.count; ++k) {
    const BodyDisplacement& d = displacements[weights.body[k]];
    moved += weights.weight[k] * (d.col(0) * p[0] + d.col(1) * p[1] + d.col(2) * p[2] + d.col(3));
  }
  return moved;
}

/// The same for every point of a surface; all spans but the last two have one entry a point.
void carryAll(std::span<const Eigen::Vector3f> rest, std::span<const BodyWeights> weights,
              std::span<const BodyDisplacement> displacements, std::span<Eigen::Vector3f> now);

}  // namespace pleura
