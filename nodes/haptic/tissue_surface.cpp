#include <pleura/nodes/core/node_type.h>
#include <pleura/nodes/haptic/tissue_surface.h>

namespace pleura {

void TissueSurface::declare(NodeType& type) {
  FrictionalSurface::declare(type);
  type.named("TissueSurface", "Pleura").means("soft: gives way where it is touched");
  using enum Access;
  // A lung under a tip of 5 mm has about 40-120 N/m, which is 0.1-0.3 of the 400 N/m that a device with 0.2 N
  // s/m of its own damping holds at 1 kHz.
  type.field<&TissueSurface::stiffness>("stiffness", inputOutput, 0.2f)
      .within(0, 1)
      .means("part of the device's largest stable stiffness; a lung has about 0.2");
  type.field<&TissueSurface::damping>("damping", inputOutput, 0.1f)
      .within(0, 1)
      .means("part of the device's largest damping");
  type.field<&TissueSurface::staticFriction>("staticFriction", inputOutput, 0)
      .within(0, 10)
      .means("sideways force that it holds, of the force into it; the pleura is wet: 0");
  type.field<&TissueSurface::dynamicFriction>("dynamicFriction", inputOutput, 0)
      .within(0, 10)
      .means("sideways force of a tip that slides, of the force into it");
}

}  // namespace pleura
