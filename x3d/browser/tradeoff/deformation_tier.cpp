#include <pleura/x3d/browser/tradeoff/deformation_tier.h>

namespace pleura {

namespace {

DeformationTier finiteElements(const std::string& method, const std::string& model, int elements) {
  return {
      method, "FiniteElementDeformer", {{"model", model}, {"elements", std::to_string(elements)}}, elements};
}

}  // namespace

std::vector<DeformationTier> deformationTiers(int coarse) {
  std::vector<DeformationTier> tiers{{"smooth fill", "", {}, 0},
                                     {"ChainMail", "ChainmailDeformer", {{"smoothing", "20"}}, 0},
                                     {"springs", "SpringDeformer", {}, 0}};
  for (const auto& [method, model] :
       {std::pair{"linear FEM", "LINEAR"}, std::pair{"corotational FEM", "COROTATIONAL"},
        std::pair{kReferenceModel, "NEO_HOOKEAN"}})
    for (const int elements : {coarse, 8 * coarse}) tiers.push_back(finiteElements(method, model, elements));
  return tiers;
}

DeformationTier tierOf(const std::string& method, int elements) {
  for (DeformationTier& tier : deformationTiers(elements))
    if (tier.method == method && tier.elements == elements) return std::move(tier);
  return {};
}

DeformationTier referenceTier(int elements) {
  return finiteElements(kReferenceMethod, "NEO_HOOKEAN", elements);
}

}  // namespace pleura
