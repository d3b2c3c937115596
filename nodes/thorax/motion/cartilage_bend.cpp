#include <algorithm>
#include <limits>
#include <stdexcept>

#include <pleura/nodes/thorax/motion/cartilage_bend.h>

namespace pleura {

double fractionAlong(std::span<const Eigen::Vector3f> centreline, const Eigen::Vector3f& point) {
  if (centreline.size() < 2) throw std::invalid_argument("fractionAlong: centreline needs two points");
  double length = 0.0;
  double nearest = std::numeric_limits<double>::max();
  double along = 0.0;
  for (std::size_t i = 0; i + 1 < centreline.size(); ++i) {
    const Eigen::Vector3d a = centreline[i].cast<double>();
    const Eigen::Vector3d ab = centreline[i + 1].cast<double>() - a;
    const Eigen::Vector3d ap = point.cast<double>() - a;
    const double squared = ab.squaredNorm();
    const double t = squared > 0.0 ? std::clamp(ap.dot(ab) / squared, 0.0, 1.0) : 0.0;
    const double distance = (ap - t * ab).squaredNorm();
    if (distance < nearest) {
      nearest = distance;
      along = length + t * ab.norm();
    }
    length += ab.norm();
  }
  return length > 0.0 ? along / length : 0.0;
}

double cartilageBlend(double t) { return t * t * (3.0 - 2.0 * t); }

std::vector<BodyWeights> bendCartilage(std::span<const Eigen::Vector3f> points,
                                       std::span<const Eigen::Vector3f> centreline, const BodyWeights& rib,
                                       const BodyWeights& end) {
  std::vector<BodyWeights> weights;
  weights.reserve(points.size());
  for (const Eigen::Vector3f& point : points) {
    weights.push_back(mix(rib, end, cartilageBlend(fractionAlong(centreline, point))));
  }
  return weights;
}

}  // namespace pleura
