#pragma once

#include <string>

namespace pleura::haptics {

/// What a device can do and how it feels in the hand. A tip is treated as one mass, alike in every direction.
struct DeviceCapabilities {
  std::string model;           // as people know it
  double maxForce = 0;         // [N] that the motors give at the tip
  double maxTorque = 0;        // [N m]; 0: the device gives none
  double maxStiffness = 0;     // [N/m] that its maker or its users render at most
  double maxDamping = 0;       // [N s/m], the same
  double workspaceRadius = 0;  // [m] of the sphere that the tip reaches, about the device's origin
  double mass = 0.045;         // [kg] that the hand feels at the tip
  double damping = 0.2;        // [N s/m] of the unpowered mechanism, b
  double friction = 0;         // [N] Coulomb friction at the tip, f_c
  double encoderStep = 0;      // [m] from one position that is told to the next, Delta
  int inputDof = 6;            // degrees of freedom that are read
  int outputDof = 3;           // degrees of freedom that are driven
  int buttons = 1;

  /// Throws DeviceError, naming the figure, on values that are not finite, negative, or zero where that can't
  /// be.
  void check() const;
};

}  // namespace pleura::haptics
