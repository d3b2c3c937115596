#include <algorithm>
#include <limits>
#include <set>

#include <fmt/format.h>

#include <pleura/x3d/browser/tradeoff/advice.h>
#include <pleura/x3d/browser/tradeoff/deformation_tier.h>

namespace pleura {

namespace {

std::string nameOf(const TierFigures& f) {
  return f.elements > 0 ? fmt::format("{} of {} elements", f.method, f.elements) : f.method;
}

std::string costOf(const TierFigures& f) {
  return f.median > 0 ? fmt::format("{:.3g} ms", 1e3 * f.median) : "what the contacts cost anyway";
}

std::string errorOf(const TierFigures& f) {
  return fmt::format("{:.2g} mm RMS, {:.2g} mm at most, {:+.2g} % of volume", 1e3 * f.error.rms,
                     1e3 * f.error.most, 100 * f.error.volume);
}

/// How far the reference was moved by its correction: what is less can't be told.
std::string doubtOf(std::span<const TierFigures> figures, const std::string& organ) {
  const auto reference = std::find_if(figures.begin(), figures.end(), [&organ](const TierFigures& f) {
    return f.organ == organ && f.method == kReferenceMethod;
  });
  if (reference == figures.end() || reference->error.rms <= 0) return {};
  return fmt::format("The reference itself was moved by {:.2g} mm when its {} elements were refined. ",
                     1e3 * reference->error.rms, reference->elements);
}

}  // namespace

const TierFigures* cheapest(std::span<const TierFigures> figures, const std::string& organ, double tolerance,
                            double budget) {
  const TierFigures* best = nullptr;
  for (const auto& f : figures) {
    if (f.organ != organ || !f.isChoosable()) continue;
    if (f.error.rms > tolerance || f.median > budget) continue;
    if (best == nullptr || f.median < best->median) best = &f;
  }
  return best;
}

std::string advice(std::span<const TierFigures> figures) {
  constexpr double kAny = std::numeric_limits<double>::infinity();
  std::set<std::string> organs;
  for (const auto& f : figures) organs.insert(f.organ);
  std::string text;
  for (const auto& organ : organs) {
    const auto* fast = cheapest(figures, organ, kAny, kAny);
    const auto* good = cheapest(figures, organ, kInvisible, kAny);
    if (fast == nullptr) continue;
    text += fmt::format("{}: the cheapest is {} ({}), off by {}. ", organ, nameOf(*fast), costOf(*fast),
                        errorOf(*fast));
    if (good == fast) {
      text += "That is less than anybody could see in a patient (0.5 mm): take it. ";
    } else if (good != nullptr) {
      text += fmt::format("For less than could be seen in a patient (0.5 mm) take {} ({}), off by {}. ",
                          nameOf(*good), costOf(*good), errorOf(*good));
    } else {
      text += "No tier comes within 0.5 mm of the reference: what is seen between the walls is a sketch. ";
    }
    text += doubtOf(figures, organ);
  }
  return text;
}

}  // namespace pleura
