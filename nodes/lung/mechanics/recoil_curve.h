#pragma once

#include <pleura/nodes/lung/mechanics/respiratory_units.h>

namespace pleura {

/// One lung at the end of a quiet exhale (FRC). The defaults are half of what two lungs have: FRC 2.3 L of
/// men, pleural pressure -5 cmH2O and compliance 0.2 L/cmH2O (Guyton; Levitzky).
struct RestingLung {
  double volume = 1.15 * kLitre;              // V_F [m^3] > 0
  double recoil = 5 * kCmH2O;                 // P_F [Pa] > 0, the transpulmonary pressure
  double compliance = 0.1 * kLitre / kCmH2O;  // C [m^3/Pa] > 0, dV/dP at P_F
};

/// The volume V [m^3] that a lung has at a transpulmonary pressure P [Pa], alveolar less intrapleural; rises
/// with P, and never negative:
///   linear   V = max(0, V_F + C (P - P_F))
///   sigmoid  V = a + b / (1 + exp(-(P - c) / d)),  V(P_F) = V_F and V'(P_F) = C give c and d
/// Source of the sigmoid's form: Narusawa 2001. The volume of a lung that nothing stretches is V(0).
class RecoilCurve {
 public:
  /// Throws std::invalid_argument when a member of `rest` is not finite and positive.
  static RecoilCurve linear(const RestingLung& rest = {});

  /// `least` a [m^3]: how much gas no pressure drives out; `most` a + b [m^3]: half of men's TLC of 5.8 L by
  /// default. Throws std::invalid_argument as linear() does, and unless 0 <= least < V_F < most.
  static RecoilCurve sigmoid(const RestingLung& rest = {}, double least = 0, double most = 2.9 * kLitre);

  double volume(double P) const;      // [m^3] at any finite P
  double compliance(double P) const;  // dV/dP [m^3/Pa], at least 0
  double leastVolume() const { return a_; }
  const RestingLung& rest() const { return rest_; }

 private:
  explicit RecoilCurve(const RestingLung& rest);

  RestingLung rest_;
  double a_ = 0, b_ = 0, c_ = 0, d_ = 0;  // b_ = 0: linear, V = c_ + d_ P
};

}  // namespace pleura
