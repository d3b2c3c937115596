#pragma once

#include <functional>
#include <vector>

#include <pleura/x3d/browser/scene/scene.h>
#include <pleura/x3d/browser/tradeoff/deformation_tier.h>
#include <pleura/x3d/browser/tradeoff/organ_breath.h>
#include <pleura/x3d/browser/tradeoff/tier_figures.h>

namespace pleura {

/// The shapes that a tier gives an organ at the moments of its breath, and what they cost.
struct TierRun {
  std::vector<std::vector<Vec3f>> shapes;
  TierFigures figures;  // without errors
};

/// `progress` is told how far it is, in [0, 1]. Throws std::invalid_argument for a shape that the deformer
/// can't take.
TierRun runTier(Scene& scene, const OrganBreath& breath, const DeformationTier& tier,
                const std::function<void(double)>& progress);

}  // namespace pleura
