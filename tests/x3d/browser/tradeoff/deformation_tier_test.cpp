#include <gtest/gtest.h>

#include <pleura/x3d/browser/tradeoff/deformation_tier.h>

namespace pleura {
namespace {

/// As kept figures name them.
TEST(DeformationTier, IsFoundAgainByMethodAndElements) {
  for (const DeformationTier& tier : deformationTiers(60)) {
    const DeformationTier found = tierOf(tier.method, tier.elements);
    EXPECT_EQ(found.name(), tier.name());
    EXPECT_EQ(found.node, tier.node);
    EXPECT_EQ(found.fields, tier.fields);
  }
  EXPECT_EQ(tierOf("ChainMail", 60).node, "");
  EXPECT_EQ(tierOf("linear FEM", 0).node, "");
  EXPECT_EQ(tierOf("magic", 60).node, "");
}

/// Cubes, and the tetrahedra that they are cut into, in lattices of the same cells.
TEST(DeformationTier, HasTwoLatticesForEachKindOfElements) {
  std::vector<std::string> names;
  for (const DeformationTier& tier : deformationTiers(60)) names.push_back(tier.name());
  EXPECT_EQ(names, (std::vector<std::string>{"smooth fill", "ChainMail", "springs", "linear tetrahedra 300",
                                             "linear tetrahedra 2400", "linear FEM 60", "linear FEM 480",
                                             "corotational FEM 60", "corotational FEM 480",
                                             "Neo-Hookean FEM 60", "Neo-Hookean FEM 480"}));
}

TEST(DeformationTier, ReferenceIsTheNonlinearModelCorrectedByTheLinear) {
  const auto [nonlinear, linear, finer] = referenceTiers(60);
  EXPECT_EQ(nonlinear.method, kReferenceMethod);
  EXPECT_EQ(nonlinear.fields, tierOf(kReferenceModel, 3840).fields);
  EXPECT_EQ(linear.name(), "linear FEM 3840");
  EXPECT_EQ(finer.name(), "linear FEM 11520");
  EXPECT_EQ(referenceTiers(300).finer.elements, 20000) << "what the node takes";
}

}  // namespace
}  // namespace pleura
