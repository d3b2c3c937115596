#include <algorithm>
#include <cmath>
#include <limits>

#include <pleura/nodes/lung/mechanics/pleural_space.h>
#include <pleura/nodes/lung/mechanics/require_positive.h>

namespace pleura {
namespace {

constexpr double kEpsilon = std::numeric_limits<double>::epsilon();
constexpr double kLargestCavity = 1;  // [m^3]
constexpr double kLeastSpace = 1e-9;  // [m^3] of the cavity beyond the least volume of the lung
constexpr int kMostIterations = 300;  // bisection alone takes 110 from the widest bracket

// A NaN is not, and raises no floating-point exception.
bool isInRange(double x, double least, double most) { return std::isfinite(x) && x >= least && x <= most; }

bool isSound(const PleuralDrain& drain, double ambient) {
  return !drain.isOn || (isInRange(drain.resistance, 1, 1e15) && isInRange(drain.suction, 0, ambient));
}

bool isSound(const LungMechanics& lung, const PleuralInputs& in, double dt) {
  const Orifice& hole = in.leak.hole;
  return isInRange(dt, kShortestStep, kLongestStep) && isInRange(in.ambientPressure, 1e3, 1e7) &&
         isInRange(in.cavityVolume, lung.recoil.leastVolume() + kLeastSpace, kLargestCavity) &&
         isInRange(hole.area, 0, 1) && isInRange(hole.dischargeCoefficient, 0, 1) &&
         isSound(in.drain, in.ambientPressure);
}

// [kg/m^3] of air at body temperature
double airDensity(double pressure) {
  constexpr double kGasConstant = 287.05;      // [J/(kg K)] of dry air
  constexpr double kBodyTemperature = 310.15;  // [K]
  return pressure / (kGasConstant * kBodyTemperature);
}

// What a guess of P makes of the step, and how each changes with P.
struct Guess {
  double V = 0, dV = 0;
  double p = 0, dp = 0;                // gauge
  double tear = 0, dTear = 0;          // q_t
  double wound = 0, drain = 0;         // q_w, q_d
  double gas = 0;                      // at the end of the step, before it is kept from falling below zero
  double residual = 0, dResidual = 0;  // (p_0 + p) (V_c - V) - film - gas [J]: falls with P
};

class Step {
 public:
  Step(const LungMechanics& lung, const PleuralInputs& in, double dt, const LungState& before)
      : lung_(lung), in_(in), dt_(dt), before_(before), rho_(airDensity(in.ambientPressure)) {}

  Guess guess(double P) const {
    Guess g;
    g.V = lung_.recoil.volume(P);
    g.dV = lung_.recoil.compliance(P);
    tear(P, g);
    const double R = lung_.airwayResistance, p0 = in_.ambientPressure;
    g.p = -P - R * ((g.V - before_.lungVolume) / dt_ + g.tear);
    g.dp = -1 - R * (g.dV / dt_ + g.dTear);
    double dInflow = g.dTear;
    dInflow += wound(g);
    dInflow -= drain(g);
    g.gas = before_.gas + dt_ * p0 * (g.wound + g.tear - g.drain);
    const double space = in_.cavityVolume - g.V;
    g.residual = (p0 + g.p) * space - before_.film - std::max(0.0, g.gas);
    g.dResidual = g.dp * space - (p0 + g.p) * g.dV - (g.gas > 0 ? dt_ * p0 * dInflow : 0);
    return g;
  }

  // Both pressure and volume of the pleural space are positive. At too high a P they are not.
  bool isPhysical(const Guess& g) const { return in_.ambientPressure + g.p > 0 && g.V < in_.cavityVolume; }

  bool isTooHigh(const Guess& g) const { return !isPhysical(g) || g.residual < 0; }

  // p <= -P + R V_before / dt, so p_0 + p < 0 from here on.
  double highest() const {
    return in_.ambientPressure + lung_.airwayResistance * before_.lungVolume / dt_ + 1;
  }

  // What the residual is uncertain by.
  double rounding(const Guess& g) const {
    return 8 * kEpsilon *
           (in_.ambientPressure * in_.cavityVolume +
            lung_.airwayResistance / dt_ * before_.lungVolume * std::abs(in_.cavityVolume - g.V));
  }

 private:
  // The alveoli are above the pleural space by P itself.
  void tear(double P, Guess& g) const {
    if (in_.leak.kind != Pneumothorax::tension || in_.leak.source != LeakSource::lung || P <= 0) return;
    const OrificeFlow flow = orificeFlow(in_.leak.hole, P, rho_);
    g.tear = flow.q;
    g.dTear = flow.slope;
  }

  // Returns dq_w/dP.
  double wound(Guess& g) const {
    const bool isValve = in_.leak.kind == Pneumothorax::tension && in_.leak.source == LeakSource::wound;
    if (in_.leak.kind != Pneumothorax::open && !(isValve && g.p < 0)) return 0;
    const OrificeFlow flow = orificeFlow(in_.leak.hole, -g.p, rho_);
    g.wound = flow.q;
    return -flow.slope * g.dp;
  }

  // Returns dq_d/dP.
  double drain(Guess& g) const {
    const double above = g.p + in_.drain.suction;
    if (!in_.drain.isOn || above <= 0) return 0;
    g.drain = above / in_.drain.resistance;
    return g.dp / in_.drain.resistance;
  }

  const LungMechanics& lung_;
  const PleuralInputs& in_;
  const double dt_;
  const LungState& before_;
  const double rho_;
};

struct Root {
  double P = 0;
  Guess at;
  int iterations = 0;
  bool isFound = false;
};

// Newton's method, and bisection where that leaves the bracket or does not halve the way.
Root solve(const Step& step, double start) {
  Root root;
  double low = std::min(start, 0.0) - kCmH2O, high = step.highest();
  while (step.isTooHigh(step.guess(low)) && ++root.iterations < kMostIterations) low *= 4;
  double way = high - low;
  root.P = start;
  while (++root.iterations < kMostIterations) {
    root.at = step.guess(root.P);
    const bool isPhysical = step.isPhysical(root.at);
    root.isFound = isPhysical && std::abs(root.at.residual) <= step.rounding(root.at);
    if (root.isFound) return root;
    (step.isTooHigh(root.at) ? high : low) = root.P;
    const double middle = low + 0.5 * (high - low);
    if (middle <= low || middle >= high) {  // neighbours in double: nothing is nearer
      root.P = low;
      root.at = step.guess(low);
      root.isFound = true;
      return root;
    }
    const bool hasSlope = root.at.dResidual < 0 && (isPhysical || root.at.residual < 0);
    const double newton = hasSlope ? root.P - root.at.residual / root.at.dResidual : high;
    const bool isGood = newton > low && newton < high && std::abs(newton - root.P) < 0.5 * way;
    const double next = isGood ? newton : middle;
    way = std::abs(next - root.P);
    root.P = next;
  }
  return root;
}

// Keeps gas from falling below zero: what leaves is no more than what is there and comes in.
void limitOutflow(const LungState& before, double ambient, double dt, Guess& g) {
  if (g.gas >= 0) return;
  const double there = before.gas / (ambient * dt) + g.tear + std::max(0.0, g.wound);
  const double share = there / (g.drain + std::max(0.0, -g.wound));
  g.drain *= share;
  if (g.wound < 0) g.wound *= share;
  g.gas = 0;
}

}  // namespace

double restingCavity(const LungMechanics& lung) { return lung.recoil.rest().volume + lung.filmVolume; }

LungState restingState(const LungMechanics& lung, double ambientPressure) {
  requirePositive(lung.airwayResistance, "pleural space: the airway's resistance");
  requirePositive(lung.filmVolume, "pleural space: the film's volume");
  requirePositive(ambientPressure, "pleural space: ambient pressure");
  const double recoil = lung.recoil.rest().recoil;
  LungState state;
  state.cavityVolume = restingCavity(lung);
  state.lungVolume = lung.recoil.rest().volume;
  state.transpulmonary = recoil;
  state.intrapleural = -recoil;
  state.film = (ambientPressure - recoil) * lung.filmVolume;
  requirePositive(state.film, "pleural space: the film's pressure");
  return state;
}

bool admitGas(double volume, double ambientPressure, LungState& state) {
  if (!isInRange(volume, 0, kLargestCavity) || !isInRange(ambientPressure, 1e3, 1e7)) return false;
  state.gas += ambientPressure * volume;
  return true;
}

PleuralReport advance(const LungMechanics& lung, const PleuralInputs& inputs, double dt, LungState& state) {
  PleuralReport report;
  report.isAccepted = isSound(lung, inputs, dt);
  if (!report.isAccepted) return report;
  Root root = solve(Step(lung, inputs, dt, state), state.transpulmonary);
  report.hasConverged = root.isFound;
  report.iterations = root.iterations;
  report.residual = std::abs(root.at.residual) / (inputs.ambientPressure * inputs.cavityVolume);
  if (!root.isFound) return report;
  Guess& g = root.at;
  limitOutflow(state, inputs.ambientPressure, dt, g);
  state.cavityFlow = (inputs.cavityVolume - state.cavityVolume) / dt;
  state.cavityVolume = inputs.cavityVolume;
  state.airFlow = (g.V - state.lungVolume) / dt + g.tear;
  state.lungVolume = g.V;
  state.intrapleural = g.p;
  state.transpulmonary = root.P;
  state.alveolar = g.p + root.P;
  state.woundFlow = g.wound;
  state.tearFlow = g.tear;
  state.drainFlow = g.drain;
  state.gas = g.gas;
  return report;
}

}  // namespace pleura
