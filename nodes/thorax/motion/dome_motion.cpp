#include <cmath>
#include <stdexcept>

#include <pleura/nodes/thorax/motion/dome_motion.h>
#include <pleura/nodes/thorax/motion/rib_motion.h>

namespace pleura {

double diaphragmContraction(double inflation) {
  if (!std::isfinite(inflation))
    throw std::invalid_argument("diaphragmContraction: inflation must be finite");
  constexpr double kLead = 0.4;
  return inflation * (1.0 + kLead * (1.0 - inflation));
}

Eigen::Isometry3d tendonMotion(const DomeMotion& dome, const Eigen::Vector3d& centre, double contraction) {
  if (!std::isfinite(contraction)) throw std::invalid_argument("tendonMotion: contraction must be finite");
  const Eigen::AngleAxisd tilt(-dome.tilt * contraction, Eigen::Vector3d::UnitX());
  Eigen::Isometry3d motion = rotationAbout(tilt.toRotationMatrix(), centre);
  motion.translation() += contraction * Eigen::Vector3d(0.0, -dome.descent, dome.forward);
  return motion;
}

}  // namespace pleura
