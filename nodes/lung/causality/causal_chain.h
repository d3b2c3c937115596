#pragma once

#include <array>

#include <pleura/nodes/lung/causality/sign_set.h>
#include <pleura/nodes/lung/mechanics/pleural_space.h>

namespace pleura {

/// The links of the chain, cause before effect (DeCarlo et al. 1995).
enum class Quantity {
  muscleForce,
  cavityVolume,
  intrapleural,
  transpulmonary,
  lungVolume,
  alveolar,
  airFlow
};
inline constexpr int kQuantities = 7;

/// One entry a Quantity.
template <class T>
struct PerQuantity : std::array<T, kQuantities> {
  T& operator[](Quantity q) { return this->data()[static_cast<int>(q)]; }
  const T& operator[](Quantity q) const { return this->data()[static_cast<int>(q)]; }
};

/// Whether a lung goes with the chest wall.
enum class Following { fully, partly, hardly, unasked };  // unasked: the wall stands

/// What changes at a moment, and what that follows from.
struct CausalChain {
  PerQuantity<Sign> change{};      // of the quantitative model, beyond the dead band
  PerQuantity<SignSet> derived{};  // what the qualitative model allows, given what is imposed

  bool isCoupled = true;            // pleural volume stands: the lung goes as the cavity does
  Sign air = Sign::stands;          // where air flows through the bronchus: rises is in, falls is out
  bool isTurning = false;           // whether the air changes its way
  Sign pleuralGas = Sign::stands;   // what the amount of gas in the pleural space does
  Sign pleuralGauge = Sign::falls;  // intrapleural pressure above atmospheric (rises) or below (falls)
  bool hasGas = false;              // in the pleural space
  bool isDraining = false;
  Pneumothorax pneumothorax = Pneumothorax::none;
  Following following = Following::unasked;

  bool operator==(const CausalChain&) const = default;
};

/// Below what a rate counts as none. All follow from that of pressures by compliance and resistance, so that
/// the signs of quantities that are linked agree.
struct DeadBands {
  double pressure;    // [Pa/s] of intrapleural, transpulmonary and alveolar pressure
  double volume;      // [m^3/s] of cavity and lung, and of air flow itself
  double flowChange;  // [m^3/s^2] of air flow
};

/// The bands at a moment; `stillness` [Pa/s] > 0 is the pressures'. A quiet breath has 300 Pa/s at most.
DeadBands deadBands(const LungMechanics& lung, const LungState& now, double stillness = 3);

/// The chain at the end of a step of dt [s] from `before` to `now`. Imposed are the cavity's change and
/// whether that quickens or slackens, gas that passes wound, tear or drain, and, where gas lets lung and wall
/// part, the way the air flows. All else is derived:
///   muscle force ~ V_c                             by rule: the muscles pull harder as long as the cavity
///   grows V_c = V + V_pl,  (p_0 + p) V_pl ~ gas,  P_A = p + P V ~ P,  dV/dt = Q - tear,  Q ~ -P_A compliance
///   and resistance constant
/// and while V_pl stands V ~ V_c and dQ/dt ~ d2V_c/dt2. Does not allocate. Both states are advance()'s, with
/// the same lung and `inputs`.
CausalChain causalChain(const LungMechanics& lung, const PleuralInputs& inputs, const LungState& before,
                        const LungState& now, double dt, double stillness = 3);

}  // namespace pleura
