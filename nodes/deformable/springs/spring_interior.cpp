#include <cmath>

#include <pleura/nodes/deformable/springs/spring_interior.h>

namespace pleura {
namespace {

InteriorState stateOf(const EmptyInterior&, const VolumeHold&, double, double) { return {}; }

// W = -n R T ln(V / V0) + p_ambient (V - V0). Below V_m its Taylor polynomial of second order there, and as
// much more as gives the ambient pressure no work to do on a surface that is inside out.
InteriorState stateOf(const GasInterior& gas, const VolumeHold&, double volume, double restVolume) {
  constexpr double kSmallest = 1e-4;
  const double v = std::fmax(volume, kSmallest * restVolume), below = volume - v;
  const double pressure = gas.amount / v - gas.ambientPressure;
  const double slope = gas.amount / (v * v) + (below < 0 ? gas.ambientPressure / v : 0);
  return {-gas.amount * std::log(v / restVolume) + gas.ambientPressure * (v - restVolume) +
              below * (slope * below / 2 - pressure),
          pressure - slope * below, slope};
}

InteriorState stateOf(const PressureInterior& interior, const VolumeHold&, double volume, double restVolume) {
  return {-interior.difference * (volume - restVolume), interior.difference, 0};
}

InteriorState stateOf(const VolumeInterior&, const VolumeHold& hold, double volume, double restVolume) {
  const double excess = volume - restVolume, slope = hold.modulus / restVolume;
  return {excess * (slope * excess / 2 - hold.multiplier), hold.multiplier - slope * excess, slope};
}

}  // namespace

InteriorState interiorAt(const SpringInterior& interior, const VolumeHold& hold, double volume,
                         double restVolume) {
  return std::visit([&](const auto& kind) { return stateOf(kind, hold, volume, restVolume); }, interior);
}

}  // namespace pleura
