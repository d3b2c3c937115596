#pragma once

#include <cstdint>
#include <vector>

#include <Eigen/Geometry>

#include <pleura/haptics/device/haptic_device.h>

namespace pleura::haptics {

/// Where a hand wants a stylus to be at one time.
struct StylusWaypoint {
  double time = 0;                                                  // [s]
  Eigen::Vector3d position = Eigen::Vector3d::Zero();               // [m], within 10 m
  Eigen::Quaterniond orientation = Eigen::Quaterniond::Identity();  // of any length but 0
  std::uint32_t buttons = 0;                                        // bit k: button k is pressed
};

/// The way of a hand over time, in the device's frame: straight from one waypoint to the next, turning
/// evenly, buttons as at the waypoint passed last; before the first and after the last it rests there.
class StylusPath {
 public:
  /// Rests at the origin.
  StylusPath();
  /// Throws DeviceError, naming the waypoint, on none, on values that `fault` refuses.
  explicit StylusPath(std::vector<StylusWaypoint> waypoints);

  /// What is wrong with a waypoint, of which `previous` is the one before (null: none); empty: nothing.
  static std::string fault(const StylusWaypoint& waypoint, const StylusWaypoint* previous);

  // Each is O(log n) and allocates nothing.
  Eigen::Vector3d position(double time) const;
  Eigen::Quaterniond orientation(double time) const;
  std::uint32_t buttons(double time) const;

  const std::vector<StylusWaypoint>& waypoints() const { return waypoints_; }

 private:
  struct Span {
    const StylusWaypoint& from;
    const StylusWaypoint& to;
    double s;  // from 0 at `from` to 1 at `to`
  };
  Span span(double time) const;

  std::vector<StylusWaypoint> waypoints_;  // at least one; orientations are unit
};

}  // namespace pleura::haptics
