#include <algorithm>
#include <cassert>
#include <cmath>
#include <tuple>

#include <pleura/haptics/contact/contact_force.h>

namespace pleura::haptics {

using Eigen::Vector3d;

Vector3d contactForce(const Proxy& proxy, const Vector3d& device, const Vector3d& velocity, double period) {
  assert(period > 0);
  Vector3d normalForce = Vector3d::Zero(), held = proxy.position() - device;
  double depths = 0, stiffness = 0, cone = 0;
  for (const ProxyContact& contact : proxy.contacts()) {
    const auto& [n, depth, surface] = std::tie(contact.normal, contact.depth, contact.surface);
    const double closing = -(velocity - contact.motion / period).dot(n);
    const double push = surface.stiffness * depth + surface.damping * closing;
    normalForce += (surface.magneticDistance > 0 ? push : std::max(0.0, push)) * n;
    held -= depth * n;
    depths += std::abs(depth);
    stiffness += std::abs(depth) * surface.stiffness;
    cone += std::abs(depth) * surface.stiffness * surface.staticFriction;
  }
  if (depths <= 0) return normalForce;
  const Vector3d friction = stiffness / depths * held;
  const double size = friction.norm();
  return normalForce + (size > cone ? Vector3d(cone / size * friction) : friction);
}

}  // namespace pleura::haptics
