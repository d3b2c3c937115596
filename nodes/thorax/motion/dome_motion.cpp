#include <pleura/nodes/thorax/motion/dome_motion.h>

#include <cmath>
#include <pleura/nodes/thorax/motion/rib_motion.h>
#include <stdexcept>

namespace pleura {

Eigen::Isometry3d tendonMotion(const DomeMotion& dome, const Eigen::Vector3d& centre, double inflation) {
  if (!std::isfinite(inflation)) throw std::invalid_argument("tendonMotion: inflation must be finite");
  const Eigen::AngleAxisd tilt(-dome.tilt * inflation, Eigen::Vector3d::UnitX());
  Eigen::Isometry3d motion = rotationAbout(tilt.toRotationMatrix(), centre);
  motion.translation() += inflation * Eigen::Vector3d(0.0, -dome.descent, dome.forward);
  return motion;
}

}  // namespace pleura
