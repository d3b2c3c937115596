#include <stdexcept>

#include <pleura/nodes/thorax/motion/skin.h>

namespace pleura {

void BodyWeights::add(int index, double w) {
  if (index < 0 || index > 255) throw std::invalid_argument("BodyWeights: index must be in 0..255");
  for (std::size_t k = 0; k < count; ++k) {
    if (body[k] == index) {
      weight[k] += static_cast<float>(w);
      return;
    }
  }
  if (count == kMax) throw std::invalid_argument("BodyWeights: at most five bodies carry a point");
  body[count] = static_cast<std::uint8_t>(index);
  weight[count++] = static_cast<float>(w);
}

BodyWeights rigidWith(int body) {
  BodyWeights weights;
  weights.add(body, 1.0);
  return weights;
}

BodyWeights mix(const BodyWeights& a, const BodyWeights& b, double t) {
  BodyWeights mixed;
  for (std::size_t k = 0; k < a.count && t < 1.0; ++k) mixed.add(a.body[k], (1.0 - t) * a.weight[k]);
  for (std::size_t k = 0; k < b.count && t > 0.0; ++k) mixed.add(b.body[k], t * b.weight[k]);
  return mixed;
}

BodyDisplacement displacementOf(const Eigen::Isometry3d& motion) {
  BodyDisplacement d = BodyDisplacement::Zero();
  d.topLeftCorner<3, 3>() = (motion.linear() - Eigen::Matrix3d::Identity()).cast<float>();
  d.topRightCorner<3, 1>() = motion.translation().cast<float>();
  return d;
}

void carryAll(std::span<const Eigen::Vector3f> rest, std::span<const BodyWeights> weights,
              std::span<const BodyDisplacement> displacements, std::span<Eigen::Vector3f> now) {
  if (weights.size() != rest.size() || now.size() != rest.size()) {
    throw std::invalid_argument("carryAll: rest, weights and now must have the same size");
  }
  for (std::size_t i = 0; i < rest.size(); ++i) {
    now[i] = carry(rest[i].homogeneous(), weights[i], displacements).head<3>();
  }
}

}  // namespace pleura
