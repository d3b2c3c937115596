#pragma once

#include <vector>

#include <Eigen/Core>

#include <pleura/nodes/deformable/mesh/triangle_mesh.h>
#include <pleura/nodes/thorax/anatomy/spline.h>

namespace pleura {

/// An elliptical cross-section of a bone, as measured at one station.
struct TubeStation {
  double fraction = 0.0;   // of the way along
  Eigen::Vector3d centre;  // [m]
  double halfMajor = 0.0;  // [m]
  double halfMinor = 0.0;  // [m]
  Eigen::Vector3d major;   // unit, direction of the major axis; its sign means nothing
};

/// A cross-section with its frame: tangent, major and minor are orthonormal and right-handed.
struct TubeSection {
  Eigen::Vector3d centre, tangent, major, minor;
  double halfMajor = 0.0;
  double halfMinor = 0.0;

  /// The point of the ellipse at an angle [rad] from the major axis towards the minor.
  Eigen::Vector3d pointAt(double angle) const;
  /// The point of the ellipse that lies farthest in a direction (which must not be along the tangent).
  Eigen::Vector3d supportPoint(const Eigen::Vector3d& direction) const;
};

/// A bone as a swept ellipse: natural cubic spline of the centres over the fraction, linear half-axes, major
/// axis made perpendicular to the tangent.
class Tube {
 public:
  /// At least two stations with strictly increasing fractions; throws std::invalid_argument otherwise.
  explicit Tube(std::vector<TubeStation> stations);

  double length() const { return arcLength_.length(); }  // [m]
  /// The cross-section at an arc length from the start [m], clamped to the tube.
  TubeSection at(double arcLength) const;
  /// Centres at equal arc lengths from end to end.
  std::vector<Eigen::Vector3d> centreline(int samples) const;

 private:
  std::vector<TubeStation> stations_;
  Spline centres_;
  ArcLength arcLength_;
};

/// The tube's skin: closed, normals outwards, rounded within its length at both ends.
TriangleMesh tubeMesh(const Tube& tube, int rings, int sectors);

}  // namespace pleura
