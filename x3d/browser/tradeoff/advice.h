#pragma once

#include <span>
#include <string>

#include <pleura/x3d/browser/tradeoff/tier_figures.h>

namespace pleura {

/// What nobody could see in a patient: observers of 4-D CT differ by more [m].
inline constexpr double kInvisible = 0.5e-3;

/// The cheapest converged figures of an organ whose RMS error is within `tolerance` [m] and whose median is
/// within `budget` [s]; null when no tier holds both. The reference is none.
const TierFigures* cheapest(std::span<const TierFigures> figures, const std::string& organ, double tolerance,
                            double budget);

/// A paragraph for somebody who has to choose.
std::string advice(std::span<const TierFigures> figures);

}  // namespace pleura
