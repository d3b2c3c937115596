#pragma once

#include <span>
#include <vector>

#include <Eigen/Core>

#include <pleura/nodes/thorax/motion/skin.h>

namespace pleura {

/// Fraction of the centreline's length at its point nearest to `point`: 0 at its start, 1 at its end.
double fractionAlong(std::span<const Eigen::Vector3f> centreline, const Eigen::Vector3f& point);

/// Share of the end's motion at fraction t of a costal cartilage: 3 t^2 - 2 t^3, so that it leaves the rib
/// and reaches its end without a kink.
double cartilageBlend(double t);

/// Weights that bend a cartilage between the rib, rigid at its start, and what its end is joined to; one per
/// point. Throws std::invalid_argument when the centreline has fewer than two points.
std::vector<BodyWeights> bendCartilage(std::span<const Eigen::Vector3f> points,
                                       std::span<const Eigen::Vector3f> centreline, const BodyWeights& rib,
                                       const BodyWeights& end);

}  // namespace pleura
