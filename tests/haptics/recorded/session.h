#pragma once

#include <algorithm>
#include <cmath>
#include <memory>

#include <pleura/haptics/device/haptic_device.h>
#include <pleura/haptics/simulated/simulated_stylus.h>

namespace pleura::haptics {

/// A stylus whose hand dips into a floor at y = 0 and out again, within half a second.
inline std::unique_ptr<SimulatedStylus> dippingStylus() {
  return std::make_unique<SimulatedStylus>(
      DeviceCapabilities{.model = "dipping",
                         .maxForce = 3.3,
                         .maxStiffness = 400,
                         .workspaceRadius = 0.1,
                         .friction = 0.01,
                         .encoderStep = 5e-5},
      StylusPath({{.time = 0, .position = {0.01, 0.01, 0}, .buttons = 1},
                  {.time = 0.25,
                   .position = {0.02, -0.01, 0.01},
                   .orientation = Eigen::Quaterniond(Eigen::AngleAxisd(0.3, Eigen::Vector3d::UnitZ())),
                   .buttons = 2},
                  {.time = 0.5, .position = {0.03, 0.01, 0}}}),
      StylusHand{});
}

/// A loop of a tick a millisecond that renders the floor and calls `told` with each time and state.
template <class Told>
void renderFloor(HapticDevice& device, double stiffness, int ticks, Told&& told) {
  DeviceState state;
  for (int tick = 0; tick < ticks; ++tick) {
    if (!device.read(tick * 0.001, state)) return;
    told(tick * 0.001, state);
    const double depth = std::max(0.0, -state.position.y());
    device.write(
        {.force = {0, stiffness * depth, -0.1 * state.velocity.z()}, .torque = {0, 0, 0.01 * depth}});
  }
}

}  // namespace pleura::haptics
