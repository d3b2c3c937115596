#include <pleura/fields/values.h>

namespace pleura {

Rotation::Rotation(const Eigen::Quaternionf& q) {
  const Eigen::AngleAxisf turn(q);
  axis = turn.axis();
  angle = turn.angle();
}

Eigen::Quaternionf Rotation::quaternion() const {
  const float length = axis.norm();
  if (length == 0) return Eigen::Quaternionf::Identity();
  return Eigen::Quaternionf(Eigen::AngleAxisf(angle, axis / length));
}

}  // namespace pleura
