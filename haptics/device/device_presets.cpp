#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <pleura/fields/nearest_name.h>
#include <pleura/haptics/device/device_presets.h>
#include <pleura/haptics/device/haptic_device.h>

namespace pleura::haptics {

// maxForce, maxStiffness, maxDamping and workspaceRadius are the caps that CHAI3D 3.3.0 sets per device: its
// authors' tuning, not data sheets. mass and damping stay our defaults, 0.045 kg and 0.2 N s/m, for every
// model: no measured ones are at hand; neither are Coulomb friction (0: none is simulated) and, but for the
// Falcon's (over 400 dpi), encoder steps (0: not quantised). maxTorque stays 0 also where a wrist is driven.
std::span<const DeviceCapabilities> devicePresets() {
  static const std::vector<DeviceCapabilities> presets = {
      {.model = "Touch",
       .maxForce = 3.3,
       .maxStiffness = 400,
       .maxDamping = 4,
       .workspaceRadius = 0.075,
       .buttons = 2},
      {.model = "Omni",
       .maxForce = 3.3,
       .maxStiffness = 700,
       .maxDamping = 5,
       .workspaceRadius = 0.10,
       .buttons = 2},
      {.model = "Desktop", .maxForce = 7.9, .maxStiffness = 1000, .maxDamping = 5, .workspaceRadius = 0.10},
      {.model = "Premium 1.5",
       .maxForce = 8.5,
       .maxStiffness = 800,
       .maxDamping = 5,
       .workspaceRadius = 0.12},
      {.model = "Premium 3.0",
       .maxForce = 22,
       .maxStiffness = 1000,
       .maxDamping = 5,
       .workspaceRadius = 0.25},
      {.model = "Falcon",
       .maxForce = 8,
       .maxStiffness = 3000,
       .maxDamping = 20,
       .workspaceRadius = 0.04,
       .encoderStep = 0.0254 / 400,
       .inputDof = 3,
       .buttons = 4},
      {.model = "omega",
       .maxForce = 12,
       .maxStiffness = 5000,
       .maxDamping = 30,
       .workspaceRadius = 0.075,
       .inputDof = 3},
      {.model = "delta",
       .maxForce = 20,
       .maxStiffness = 5000,
       .maxDamping = 30,
       .workspaceRadius = 0.15,
       .inputDof = 3,
       .buttons = 0},
      {.model = "sigma.7",
       .maxForce = 12,
       .maxStiffness = 4000,
       .maxDamping = 30,
       .workspaceRadius = 0.075,
       .inputDof = 7,
       .outputDof = 7},
      {.model = "lambda.7",
       .maxForce = 12,
       .maxStiffness = 8000,
       .maxDamping = 30,
       .workspaceRadius = 0.1125,
       .inputDof = 7,
       .outputDof = 7},
  };
  return presets;
}

const DeviceCapabilities& devicePreset(std::string_view model) {
  std::vector<std::string_view> known;
  for (const auto& preset : devicePresets()) {
    if (isSameName(preset.model, model)) return preset;
    known.push_back(preset.model);
  }
  throw DeviceError(fmt::format("no haptic device \"{}\", known are {}{}", model, fmt::join(known, ", "),
                                didYouMean(nearestName(model, known))));
}

}  // namespace pleura::haptics
