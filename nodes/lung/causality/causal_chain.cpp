#include <algorithm>
#include <cassert>
#include <cmath>

#include <pleura/nodes/lung/causality/causal_chain.h>
#include <pleura/nodes/lung/causality/sign_constraints.h>

namespace pleura {
namespace {

// A lung pressed so empty that its compliance is less than this share of that at rest changes its
// transpulmonary pressure with no volume to see.
constexpr double kLeastCompliance = 0.01;

bool isCompliant(const LungMechanics& lung, const LungState& at) {
  return lung.recoil.compliance(at.transpulmonary) >= kLeastCompliance * lung.recoil.rest().compliance;
}

// Rates of a step, [per s].
struct Rates {
  double cavity, cavityQuickens;  // d2V_c/dt2
  double pleural, pleuralQuickens;
  double lung, intrapleural, transpulmonary, alveolar, airFlow;
  double gas;  // [m^3/s] at ambient pressure
};

double lungFlow(const LungState& s) { return s.airFlow - s.tearFlow; }

double pleuralFlow(const LungState& s) { return s.cavityFlow - lungFlow(s); }

// Also what admitGas() let in.
double gasFlow(const LungState& before, const LungState& now, double ambient, double dt) {
  return (now.film + now.gas - (ambient + before.intrapleural) * before.pleuralVolume()) / (ambient * dt);
}

Rates ratesOf(const LungState& before, const LungState& now, double ambient, double dt) {
  return {.cavity = now.cavityFlow,
          .cavityQuickens = (now.cavityFlow - before.cavityFlow) / dt,
          .pleural = pleuralFlow(now),
          .pleuralQuickens = (pleuralFlow(now) - pleuralFlow(before)) / dt,
          .lung = lungFlow(now),
          .intrapleural = (now.intrapleural - before.intrapleural) / dt,
          .transpulmonary = (now.transpulmonary - before.transpulmonary) / dt,
          .alveolar = (now.alveolar - before.alveolar) / dt,
          .airFlow = (now.airFlow - before.airFlow) / dt,
          .gas = gasFlow(before, now, ambient, dt)};
}

PerQuantity<Sign> changes(const Rates& r, const DeadBands& band) {
  PerQuantity<Sign> change;
  change[Quantity::muscleForce] = change[Quantity::cavityVolume] = signOf(r.cavity, band.volume);
  change[Quantity::intrapleural] = signOf(r.intrapleural, band.pressure);
  change[Quantity::transpulmonary] = signOf(r.transpulmonary, band.pressure);
  change[Quantity::lungVolume] = signOf(r.lung, band.volume);
  change[Quantity::alveolar] = signOf(r.alveolar, band.pressure);
  change[Quantity::airFlow] = signOf(r.airFlow, band.flowChange);
  return change;
}

// What is known of quantities beside the chain's.
struct Known {
  SignSet air, tear, gas, pleural;
  bool isCoupled, isCompliant;
};

PerQuantity<SignSet> propagate(PerQuantity<SignSet> q, Known k) {
  SignSet& cavity = q[Quantity::cavityVolume];
  SignSet& lung = q[Quantity::lungVolume];
  SignSet& p = q[Quantity::intrapleural];
  SignSet& P = q[Quantity::transpulmonary];
  SignSet& alveolar = q[Quantity::alveolar];
  bool hasChanged = true;
  while (hasChanged) {
    hasChanged = narrowAlike(q[Quantity::muscleForce], cavity);
    hasChanged |= k.isCoupled ? narrowAlike(cavity, lung) : narrowSum(lung, k.pleural, cavity);
    if (!k.isCoupled) hasChanged |= narrowProduct(p, k.pleural, k.gas);
    hasChanged |= narrowSum(lung, k.tear, k.air);
    if (k.isCompliant) hasChanged |= narrowAlike(P, lung);
    hasChanged |= narrowSum(p, P, alveolar);
    hasChanged |= narrowContrary(alveolar, q[Quantity::airFlow]);
  }
  return q;
}

// A tenth of what the cavity does, or less than is looked at.
bool isSmall(double pleural, double cavity, double band) {
  return std::abs(pleural) <= std::max(band / 4, std::abs(cavity) / 10);
}

bool isCoupled(const Rates& r, const DeadBands& band) {
  return isSmall(r.pleural, r.cavity, band.volume) &&
         isSmall(r.pleuralQuickens, r.cavityQuickens, band.flowChange);
}

Following followingOf(const Rates& r, const DeadBands& band) {
  if (std::abs(r.cavity) <= 2 * band.volume) return Following::unasked;
  const double share = r.lung / r.cavity;
  return share > 0.95 ? Following::fully : share > 0.5 ? Following::partly : Following::hardly;
}

}  // namespace

DeadBands deadBands(const LungMechanics& lung, const LungState& now, double stillness) {
  const double least = kLeastCompliance * lung.recoil.rest().compliance;
  return {.pressure = stillness,
          .volume = stillness * std::max(least, lung.recoil.compliance(now.transpulmonary)),
          .flowChange = stillness / lung.airwayResistance};
}

CausalChain causalChain(const LungMechanics& lung, const PleuralInputs& inputs, const LungState& before,
                        const LungState& now, double dt, double stillness) {
  assert(dt > 0 && stillness > 0);
  const DeadBands band = deadBands(lung, now, stillness);
  const Rates r = ratesOf(before, now, inputs.ambientPressure, dt);
  CausalChain chain;
  chain.change = changes(r, band);
  chain.isCoupled = isCoupled(r, band);
  PerQuantity<SignSet> imposed;
  imposed[Quantity::cavityVolume] = SignSet::of(r.cavity, band.volume);
  if (chain.isCoupled) imposed[Quantity::airFlow] = SignSet::of(r.cavityQuickens, band.flowChange);
  const Known known{.air = chain.isCoupled ? SignSet() : SignSet::of(now.airFlow, band.volume),
                    .tear = SignSet::of(now.tearFlow, band.volume),
                    .gas = SignSet::of(r.gas, band.volume),
                    .pleural = {},
                    .isCoupled = chain.isCoupled,
                    .isCompliant = isCompliant(lung, before) && isCompliant(lung, now)};
  chain.derived = propagate(imposed, known);
  chain.air = signOf(now.airFlow, band.volume);
  chain.isTurning = chain.change[Quantity::airFlow] != Sign::stands &&
                    (chain.air == Sign::stands || (before.airFlow < 0) != (now.airFlow < 0));
  chain.pleuralGas = signOf(r.gas, band.volume);
  chain.pleuralGauge = signOf(now.intrapleural, 0.1 * kCmH2O);
  chain.hasGas = now.gas > 0;
  chain.isDraining = now.drainFlow > 0;
  chain.pneumothorax = inputs.leak.kind;
  chain.following = followingOf(r, band);
  return chain;
}

}  // namespace pleura
