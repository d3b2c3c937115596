#pragma once

#include <pleura/haptics/contact/proxy.h>

namespace pleura::haptics {

/// The force [N] on a device at `device` [m] that goes at `velocity` [m/s], and whose last tick took `period`
/// [s] > 0: F = sum_i (K_i depth_i - B_i (v - v_i) . n_i) n_i + K t, where v_i is the surface's own velocity,
/// t what friction holds the proxy back by and K the mean stiffness, weighted by depth. No surface pulls but
/// magnetic ones, and K t stays within the cone of static friction.
Eigen::Vector3d contactForce(const Proxy& proxy, const Eigen::Vector3d& device,
                             const Eigen::Vector3d& velocity, double period);

}  // namespace pleura::haptics
