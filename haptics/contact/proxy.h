#pragma once

#include <cstdint>
#include <span>

#include <Eigen/Geometry>

#include <pleura/haptics/contact/touch_mesh.h>
#include <pleura/haptics/contact/touch_surface.h>

namespace pleura::haptics {

/// A touchable shape at one instant: its points are (1 - s) from + s to, in a frame that stands in the world
/// at `pose`. What is pointed to outlives the call that it is given to.
struct TouchShape {
  std::uint32_t id = 0;  // the same in every instant
  const TouchMesh* mesh = nullptr;
  const TouchMeshFrame* from = nullptr;
  const TouchMeshFrame* to = nullptr;  // the same as `from` for a rigid shape
  float s = 1;                         // 0..1
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  TouchSurface surface;
};

/// One of the places where the proxy rests on a shape, in world space.
struct ProxyContact {
  std::uint32_t shape = 0;  // id
  int triangle = -1;
  Eigen::Vector3d weights;  // barycentric, of the triangle's corners
  Eigen::Vector3d point;    // [m] on the surface
  Eigen::Vector3d normal;   // unit, from the surface to the proxy's centre
  double depth = 0;  // [m] that the device is in along the normal, >= 0: its share where contacts are several
};

/// A ball that follows the device and never goes through a surface (Zilles and Salisbury 1995, Ruspini 1997),
/// whatever the surface does meanwhile: what it rests on carries it along.
class Proxy {
 public:
  static constexpr int kMaxContacts = 3;

  /// radius [m] > 0 of the ball.
  explicit Proxy(double radius);

  /// Puts the ball there, touching nothing.
  void reset(const Eigen::Vector3d& position);

  /// One haptic tick: what it touched carries it, then it goes as near to the device as surfaces and friction
  /// let it. No allocation.
  void follow(std::span<const TouchShape> shapes, const Eigen::Vector3d& device);

  /// [m], of the centre.
  const Eigen::Vector3d& position() const;
  std::span<const ProxyContact> contacts() const;
};

}  // namespace pleura::haptics
