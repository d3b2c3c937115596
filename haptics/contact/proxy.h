#pragma once

#include <array>
#include <cstdint>
#include <span>

#include <Eigen/Core>

#include <pleura/haptics/contact/clear_space.h>
#include <pleura/haptics/contact/neighbourhood.h>
#include <pleura/haptics/contact/touch_shape.h>

namespace pleura::haptics {

/// One of the places where the proxy rests on a shape, in world space.
struct ProxyContact {
  std::uint32_t shape = 0;  // id
  int triangle = -1;
  Eigen::Vector3d weights;  // barycentric, of the triangle's corners
  Eigen::Vector3d point;    // [m] on the surface
  Eigen::Vector3d normal;   // unit, from the surface to the proxy's centre
  Eigen::Vector3d motion;   // [m] that the surface went there since the last tick
  /// [m] that the device is in along the normal, >= 0: proxy - device = sum depth * normal + what friction
  /// holds back. Below 0 only where a magnetic surface holds the proxy and the device is off it.
  double depth = 0;
  TouchSurface surface;
};

/// A ball that follows the device and never goes through a surface (Zilles and Salisbury 1995, Ruspini 1997),
/// whatever the surface does meanwhile: what it rests on carries it along.
///
/// A step goes to the point nearest to the device that can be reached straight on (see ClearSpace), and steps
/// follow each other until none goes any nearer.
class Proxy {
 public:
  static constexpr int kMaxContacts = 3;

  /// radius [m] > 0 of the ball.
  explicit Proxy(double radius);
  Proxy(const Proxy&) = delete;
  Proxy& operator=(const Proxy&) = delete;

  /// Puts the ball there, touching nothing. What it stands in or behind isn't felt until the ball has left
  /// it.
  void reset(const Eigen::Vector3d& position);

  /// One haptic tick: what it touched carries it, then it goes as near to the device as surfaces and friction
  /// let it. A device position that isn't finite, or is beyond 1e6 m, counts as the last good one. No
  /// allocation.
  void follow(std::span<const TouchShape> shapes, const Eigen::Vector3d& device);

  double radius() const { return radius_; }
  /// [m], of the centre.
  const Eigen::Vector3d& position() const { return position_; }
  std::span<const ProxyContact> contacts() const {
    return {contacts_.data(), static_cast<std::size_t>(contactCount_)};
  }

 private:
  Eigen::Vector3d carried() const;
  /// What a magnetic surface does.
  struct Pull {
    int label;              // of its plane in space_, or -1
    double height;          // [m] that the device is off the surface
    Eigen::Vector3d place;  // where the ball is wanted then
  };

  Pull pullOn(const Eigen::Vector3d& device, const Eigen::Vector3d& drag) const;
  Eigen::Vector3d stepTo(const Pull& pull, const HalfSpaceProjection& free, Eigen::Vector3d& anchor,
                         Eigen::Vector3d& drag) const;
  void rest(const Pull& pull, const HalfSpaceProjection& free);
  void addContact(int label, double depth);
  const TouchSurface& surface(int label) const;

  double radius_;
  Eigen::Vector3d position_ = Eigen::Vector3d::Zero();
  Eigen::Vector3d device_ = Eigen::Vector3d::Zero();
  Neighbourhood near_;
  ClearSpace space_;
  std::array<ProxyContact, kMaxContacts> contacts_;
  int contactCount_ = 0;
  double stride_ = 0;            // [m] that is looked about for
  double magneticDistance_ = 0;  // [m] the greatest of all shapes
  bool slides_ = false;
};

}  // namespace pleura::haptics
