#include <algorithm>
#include <array>

#include <pleura/x3d/browser/tradeoff/deformation_tier.h>

namespace pleura {

namespace {

/// Finite elements of one kind.
struct LatticeMethod {
  const char* name;
  const char* model;
  const char* elementType;
  int elementsPerCell;

  DeformationTier tier(int elements) const {
    return {name,
            "FiniteElementDeformer",
            {{"model", model}, {"elementType", elementType}, {"elements", std::to_string(elements)}},
            elements};
  }
};

constexpr std::array<LatticeMethod, 4> kLatticeMethods{{{"linear tetrahedra", "LINEAR", "TETRAHEDRON", 5},
                                                        {"linear FEM", "LINEAR", "HEXAHEDRON", 1},
                                                        {"corotational FEM", "COROTATIONAL", "HEXAHEDRON", 1},
                                                        {kReferenceModel, "NEO_HOOKEAN", "HEXAHEDRON", 1}}};

std::vector<DeformationTier> tiersWithoutLattice() {
  return {{"smooth fill", "", {}, 0},
          {"ChainMail", "ChainmailDeformer", {{"smoothing", "20"}}, 0},
          {"springs", "SpringDeformer", {}, 0}};
}

}  // namespace

std::vector<DeformationTier> deformationTiers(int coarse) {
  std::vector<DeformationTier> tiers = tiersWithoutLattice();
  for (const LatticeMethod& method : kLatticeMethods)
    for (const int cells : {coarse, 8 * coarse}) tiers.push_back(method.tier(cells * method.elementsPerCell));
  return tiers;
}

DeformationTier tierOf(const std::string& method, int elements) {
  for (DeformationTier& tier : tiersWithoutLattice())
    if (tier.method == method && elements == 0) return std::move(tier);
  for (const LatticeMethod& known : kLatticeMethods)
    if (known.name == method && elements > 0) return known.tier(elements);
  return {};
}

ReferenceTiers referenceTiers(int coarse) {
  constexpr int kMost = 20000;  // that FiniteElementDeformer takes
  constexpr auto kLinear = "linear FEM";
  const int elements = 64 * coarse;
  ReferenceTiers tiers{tierOf(kReferenceModel, elements), tierOf(kLinear, elements),
                       tierOf(kLinear, std::min(3 * elements, kMost))};
  tiers.nonlinear.method = kReferenceMethod;
  return tiers;
}

}  // namespace pleura
