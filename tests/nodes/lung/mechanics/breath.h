#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include <pleura/nodes/lung/mechanics/pleural_space.h>

namespace pleura {

/// What a hemithorax does in a breath: its volume above FRC, half-cosines out and back.
struct Breath {
  double period = 4;             // [s] 15 breaths a minute
  double depth = 0.25 * kLitre;  // [m^3] of one side: two make a tidal volume of 0.5 L
  double inspiration = 0.5;      // part of the period; 1/3 is one to two
  double pauseFrom = 1e9;        // [s] the time at which it stops ...
  double pauseFor = 0;           // [s] ... and for how long

  double at(double t) const {
    const double paused = std::clamp(t - pauseFrom, 0.0, pauseFor);
    const double phase = std::fmod((t - paused) / period, 1);
    const double u =
        phase < inspiration ? phase / inspiration : 1 + (phase - inspiration) / (1 - inspiration);
    return depth * (1 - std::cos(std::numbers::pi * u)) / 2;
  }
};

inline constexpr Breath kOneToTwo{.inspiration = 1.0 / 3};

/// A lung, what is done to it and where it is.
struct BreathingLung {
  LungMechanics lung;
  PleuralInputs inputs;
  LungState now = restingState(lung);

  BreathingLung(const LungMechanics& mechanics = {}) : lung(mechanics) { hold(0); }

  double unstretched() const { return lung.recoil.volume(0); }

  /// Sets the cavity's volume above FRC [m^3].
  void hold(double volume) { inputs.cavityVolume = restingCavity(lung) + volume; }

  void step(double dt) {
    const PleuralReport report = advance(lung, inputs, dt, now);
    ASSERT_TRUE(report.isAccepted && report.hasConverged);
  }

  void steps(int count, double dt) {
    for (int k = 0; k < count; ++k) step(dt);
  }

  /// From time 0 on; calls `each(t)` after every step.
  template <class Each>
  void breathe(const Breath& breath, double seconds, double dt, Each each) {
    const long count = std::lround(seconds / dt);
    for (long k = 1; k <= count; ++k) {
      const double t = static_cast<double>(k) * dt;
      hold(breath.at(t));
      step(dt);
      each(t);
    }
  }

  void breathe(const Breath& breath, double seconds, double dt) {
    breathe(breath, seconds, dt, [](double) {});
  }
};

inline LungMechanics sigmoidLung() {
  LungMechanics lung;
  lung.recoil = RecoilCurve::sigmoid();
  return lung;
}

/// Air at body temperature and 101325 Pa, [kg/m^3].
inline constexpr double kAirDensity = 101325 / (287.05 * 310.15);

/// A wound of this area [m^2].
inline PleuralLeak wound(Pneumothorax kind, double area) { return {.kind = kind, .hole = {.area = area}}; }

}  // namespace pleura
