#pragma once

#include <pleura/nodes/lung/mechanics/pneumothorax.h>
#include <pleura/nodes/lung/mechanics/recoil_curve.h>

namespace pleura {

/// One lung and its pleural space. Two of them are two instances that share nothing but the air outside.
struct LungMechanics {
  RecoilCurve recoil = RecoilCurve::linear();
  double airwayResistance =
      3 * kCmH2O / kLitre;   // R [Pa s/m^3] > 0 of this lung's bronchus; two of them side by
                             // side are the 1.5 cmH2O s/L of both (DuBois 1956: 1.01 - 1.99)
  double filmVolume = 1e-6;  // [m^3] > 0 of the liquid film, at rest
};

/// What is imposed on a step.
struct PleuralInputs {
  double cavityVolume = 0;          // V_c [m^3] of lung and pleural space together; restingCavity() at FRC
  double ambientPressure = 101325;  // p_0 [Pa], at mouth and wound
  PleuralLeak leak;
  PleuralDrain drain;
};

/// A moment. Pressures are gauge, above ambient. Gas is counted in joules, pressure times volume at body
/// temperature, which entering air takes at once.
struct LungState {
  double cavityVolume = 0;    // V_c [m^3]
  double lungVolume = 0;      // V [m^3]
  double intrapleural = 0;    // p [Pa]
  double alveolar = 0;        // P_A [Pa]
  double transpulmonary = 0;  // P = P_A - p [Pa]
  double airFlow = 0;         // Q [m^3/s] into the lung through its bronchus
  double cavityFlow = 0;      // dV_c/dt [m^3/s] over the last step
  double woundFlow = 0;  // [m^3/s, at ambient pressure] into the pleural space from outside, negative out
  double tearFlow = 0;   // the same from the lung, never negative
  double drainFlow = 0;  // the same out through the drain, never negative
  double film = 0;       // [J] that stands for the liquid film, constant
  double gas = 0;        // [J] of a pneumothorax, never negative

  double pleuralVolume() const { return cavityVolume - lungVolume; }
};

/// What a step did.
struct PleuralReport {
  bool isAccepted = false;    // whether the inputs were sound; if not, the state is as it was
  bool hasConverged = false;  // if not, the state is as it was
  int iterations = 0;
  double residual = 0;  // of p V, a part of the cavity's
};

/// V_c [m^3] at FRC: the lung's volume and the film's.
double restingCavity(const LungMechanics& lung);

/// FRC without flow, at ambient pressure p_0 [Pa] > 0. Throws std::invalid_argument when a number of `lung`
/// or p_0 is not finite and positive.
LungState restingState(const LungMechanics& lung, double ambientPressure = 101325);

/// Lets `volume` [m^3] >= 0 of gas, measured at ambient pressure p_0 [Pa], into the pleural space at once;
/// the next step tells what comes of it. Whether it did: what is not finite or negative is refused.
bool admitGas(double volume, double ambientPressure, LungState& state);

/// Steps of time [s] that advance() takes; the longest gives the static answer.
inline constexpr double kShortestStep = 1e-6, kLongestStep = 1e3;

/// Advances a lung by dt [s], backward Euler:
///   dV/dt + q_t = Q = -P_A / R              air through the bronchus
///   P_A = p + P,  V = V(P)                  recoil
///   (p_0 + p) (V_c - V) = film + gas        P V = constant
///   d gas/dt = p_0 (q_w + q_t - q_d)        wound, torn lung, drain
/// The thin liquid film is a very small amount of gas that never leaves: so one law holds with a pneumothorax
/// and without, and pleural volume changes by p / p_0 of the film's alone (1e-5 of a breath). Air in the lung
/// is taken as incompressible: alveolar pressure is within 0.2 % of ambient. The four equations are one in P,
/// monotone, so they have one root at any dt; Newton's method within a bracket finds it. The cavity is
/// imposed: no chest wall gives way to the pressure.
///
/// Refused, with the state left as it was: what is not finite, dt outside its limits, V_c less than 1 uL
/// above the least volume of the lung or over 1 m^3, p_0 outside [1e3, 1e7] Pa, a hole's area [m^2] or
/// coefficient outside [0, 1], a drain's resistance outside [1, 1e15] Pa s/m^3 or suction outside [0, p_0].
/// Does not throw or allocate.
PleuralReport advance(const LungMechanics& lung, const PleuralInputs& inputs, double dt, LungState& state);

}  // namespace pleura
