#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <pleura/nodes/lung/mechanics/recoil_curve.h>
#include <pleura/nodes/lung/mechanics/require_positive.h>

namespace pleura {
namespace {

// 1 / (1 + exp(-z)), without overflow
double logistic(double z) {
  const double e = std::exp(-std::abs(z));
  return z >= 0 ? 1 / (1 + e) : e / (1 + e);
}

}  // namespace

RecoilCurve::RecoilCurve(const RestingLung& rest) : rest_(rest) {
  requirePositive(rest.volume, "recoil curve: the lung's volume at rest");
  requirePositive(rest.recoil, "recoil curve: the transpulmonary pressure at rest");
  requirePositive(rest.compliance, "recoil curve: the compliance at rest");
}

RecoilCurve RecoilCurve::linear(const RestingLung& rest) {
  RecoilCurve curve(rest);
  curve.c_ = rest.volume - rest.compliance * rest.recoil;
  curve.d_ = rest.compliance;
  return curve;
}

RecoilCurve RecoilCurve::sigmoid(const RestingLung& rest, double least, double most) {
  RecoilCurve curve(rest);
  if (!(std::isfinite(least) && std::isfinite(most) && 0 <= least && least < rest.volume &&
        rest.volume < most))
    throw std::invalid_argument("recoil curve: 0 <= least < volume at rest < most does not hold");
  curve.a_ = least;
  curve.b_ = most - least;
  const double s = (rest.volume - least) / curve.b_;  // V(P_F) = a + b s,  V'(P_F) = b s (1 - s) / d
  curve.d_ = curve.b_ * s * (1 - s) / rest.compliance;
  curve.c_ = rest.recoil - curve.d_ * std::log(s / (1 - s));
  return curve;
}

double RecoilCurve::volume(double P) const {
  return b_ == 0 ? std::max(0.0, c_ + d_ * P) : a_ + b_ * logistic((P - c_) / d_);
}

double RecoilCurve::compliance(double P) const {
  if (b_ == 0) return c_ + d_ * P > 0 ? d_ : 0;
  const double s = logistic((P - c_) / d_), t = logistic((c_ - P) / d_);  // t = 1 - s, without cancelling
  return b_ * s * t / d_;
}

}  // namespace pleura
