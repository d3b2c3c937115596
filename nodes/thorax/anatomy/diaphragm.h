#pragma once

#include <array>
#include <vector>

#include <pleura/nodes/thorax/anatomy/anatomy.h>
#include <pleura/nodes/thorax/anatomy/chest_wall.h>

namespace pleura {

/// The measured surface of the diaphragm (measurements/diaphragm.csv) as a function of azimuth and s: dome
/// for s in [0, 1], zone of apposition for s in [1, 2]. Azimuth as in Diaphragm, about the table's vertical
/// axis.
class DiaphragmShape {
 public:
  DiaphragmShape();

  static constexpr int kColumns = 24;
  static constexpr int kKnots = 16;

  /// A meridian: its points at the knots of s, monotone cubics around the axis (Fritsch & Carlson 1980).
  std::array<Eigen::Vector3d, kKnots> meridian(double azimuth) const;
  const std::vector<double>& knots() const { return knots_; }  // of s
  /// The s as far as which the central tendon reaches.
  double tendonEdge(double azimuth) const;
  /// Height of the dome [m] above or below a point; beyond the dome's edge, the edge's height.
  double heightAt(const Eigen::Vector3d& point) const;
  double azimuthOf(const Eigen::Vector3d& point) const;

 private:
  using Rows = std::array<std::array<double, kKnots>, kColumns>;

  Eigen::Vector3d axis_;       // the point s = 0
  std::vector<double> knots_;  // values of s
  Rows radius_, height_;       // [m] from the axis; [m]
  std::array<double, kColumns> tendonEdge_{};
};

/// The highest point on one side, off the midline [m].
Eigen::Vector3f domeTop(const TriangleMesh& mesh, Side side);

/// A point moved towards the lungs onto the walls (left, right) of the cage if it lies beyond them; in the
/// midline, where neither has bones, they open.
Eigen::Vector3f pressedInside(const std::array<ChestWall, 2>& walls, const Eigen::Vector3f& point);

/// The diaphragm as an open sheet of about 2,000 points, nowhere beyond the walls (left, right) of the cage.
Diaphragm generateDiaphragm(const DiaphragmShape& shape, const std::array<ChestWall, 2>& walls);

}  // namespace pleura
