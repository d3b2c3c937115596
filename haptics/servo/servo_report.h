#pragma once

#include <array>

#include <pleura/haptics/contact/proxy.h>
#include <pleura/haptics/device/haptic_device.h>

namespace pleura::haptics {

/// What the haptic loop tells the scene after a tick. Positions [m] and forces [N] in the world but where
/// they are said to be the device's.
struct ServoReport {
  static constexpr int kMaxEffects = 16;

  struct Contact {
    std::uint32_t shape = 0;  // id
    Eigen::Vector3d point = Eigen::Vector3d::Zero();
    Eigen::Vector3d normal = Eigen::Vector3d::Zero();  // unit, out of the surface
    double depth = 0;                                  // [m] that the device is in, in the scene's metres
    Eigen::Vector3d force = Eigen::Vector3d::Zero();   // on the tip
  };

  double time = 0;           // [s] of the loop's clock
  bool isConnected = false;  // the device answers
  bool isStopped = false;    // the watchdog holds the force at zero
  DeviceState device;        // in the device's own frame
  Eigen::Vector3d trackerPosition = Eigen::Vector3d::Zero();
  Eigen::Quaterniond trackerOrientation = Eigen::Quaterniond::Identity();
  Eigen::Vector3d trackerVelocity = Eigen::Vector3d::Zero();  // [m/s]
  Eigen::Vector3d proxyPosition = Eigen::Vector3d::Zero();
  Eigen::Vector3d force = Eigen::Vector3d::Zero();   // that the hand is given
  Eigen::Vector3d torque = Eigen::Vector3d::Zero();  // [N m]
  int contactCount = 0;
  std::array<Contact, Proxy::kMaxContacts> contacts;
  int effectCount = 0;
  std::array<Eigen::Vector3d, kMaxEffects> effectForces;  // in the frame's order
  std::array<bool, kMaxEffects> isEffectActive{};
};

}  // namespace pleura::haptics
