#pragma once

#include <variant>

namespace pleura {

/// What a closed surface of springs holds.
struct EmptyInterior {};

/// A gas at constant temperature, p V = n R T.
struct GasInterior {
  double amount = 0;           // n R T [J], 0 or more
  double ambientPressure = 0;  // outside [Pa], absolute as the gas' own is, 0 or more
};

/// Inside less outside [Pa], the same at every volume; negative pulls the surface in.
struct PressureInterior {
  double difference = 0;
};

/// The volume at rest, whatever pressure that takes.
struct VolumeInterior {};

using SpringInterior = std::variant<EmptyInterior, GasInterior, PressureInterior, VolumeInterior>;

/// Energy of an interior by its volume, W(V), and what follows from it.
struct InteriorState {
  double energy = 0;    // W [J], 0 at the rest volume
  double pressure = 0;  // -dW/dV [Pa], inside less outside
  double slope = 0;     // d2W/dV2 [Pa/m^3], never negative
};

/// What holds a volume: p = multiplier + modulus (1 - V / V0), an augmented Lagrangian (Nocedal and Wright,
/// Numerical Optimization, 17.3) with the pressure as its multiplier.
struct VolumeHold {
  double multiplier = 0;  // [Pa]
  double modulus = 0;     // [Pa]
};

/// State at a volume V of any sign [m^3], rest volume V0 > 0. Below V0 / 10,000 the pressure of a gas goes on
/// in a straight line, steep enough to blow up a surface that is inside out, whatever the ambient pressure.
InteriorState interiorAt(const SpringInterior& interior, const VolumeHold& hold, double volume,
                         double restVolume);

}  // namespace pleura
