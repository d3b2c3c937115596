#include <pleura/nodes/core/node_type.h>
#include <pleura/nodes/haptic/magnetic_surface.h>

namespace pleura {

void MagneticSurface::declare(NodeType& type) {
  FrictionalSurface::declare(type);
  type.named("MagneticSurface", "Pleura").means("draws the tip to itself and holds it");
  using enum Access;
  type.field<&MagneticSurface::snapDistance>("snapDistance", inputOutput, 0.01f)
      .measuredIn(Unit::length)
      .atLeast(0)
      .means("from which it draws the tip, and beyond which it lets go");
}

haptics::TouchSurface MagneticSurface::surfaceOn(double most, double mostDamping) {
  haptics::TouchSurface surface = FrictionalSurface::surfaceOn(most, mostDamping);
  surface.magneticDistance = snapDistance.getValue();
  return surface;
}

}  // namespace pleura
