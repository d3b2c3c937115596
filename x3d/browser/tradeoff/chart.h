#pragma once

#include <span>
#include <string>

#include <pleura/x3d/browser/tradeoff/tier_figures.h>

namespace pleura {

/// Error over cost, both on logarithmic scales, a field for each organ and a line for each method.
/// As SVG.
std::string chartAsSvg(std::span<const TierFigures> figures);
/// The same as an X3D scene, 8 wide and as high as it has organs, to be drawn as it is from the front.
std::string chartAsScene(std::span<const TierFigures> figures);
/// Height over width.
double chartAspect(std::span<const TierFigures> figures);

}  // namespace pleura
