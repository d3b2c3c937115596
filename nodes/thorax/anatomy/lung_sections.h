#pragma once

#include <vector>

#include <Eigen/Core>

#include <pleura/nodes/thorax/anatomy/anatomy.h>

namespace pleura {

/// One lung's measured horizontal sections (measurements/lungs.csv) as a solid: signed distances to the
/// outlines, interpolated over the height (Raya & Udupa 1990).
class LungSections {
 public:
  explicit LungSections(Side side);

  /// About the distance to the lung's skin, negative inside [m]. Below the lowest section the lowest goes on:
  /// the base is the diaphragm's to draw.
  double distance(const Eigen::Vector3d& point) const;

 private:
  using Outline = std::vector<Eigen::Vector2d>;  // (x, z) [m], closed
  struct Section {
    double height;
    std::vector<Outline> outlines;
  };
  static double distance(const Section& section, const Eigen::Vector2d& point);

  std::vector<Section> sections_;  // upwards
};

}  // namespace pleura
