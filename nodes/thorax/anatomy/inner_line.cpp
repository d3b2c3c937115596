#include <algorithm>

#include <pleura/nodes/thorax/anatomy/inner_line.h>

namespace pleura {

using Eigen::Vector3d;

Vector3d lungAxisNear(const Vector3d& point, Side side) {
  return {sign(side) * 0.063, std::min(point.y(), 0.1), 0.0};
}

std::vector<Eigen::Vector3f> innerLine(const Tube& tube, Side side, int samples) {
  std::vector<Eigen::Vector3f> line;
  for (int k = 0; k < samples; ++k) {
    const TubeSection section = tube.at(tube.length() * k / (samples - 1));
    line.push_back(section.supportPoint(lungAxisNear(section.centre, side) - section.centre).cast<float>());
  }
  return line;
}

}  // namespace pleura
