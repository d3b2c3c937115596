#include <limits>
#include <stdexcept>

#include "organ.h"
#include <gtest/gtest.h>

#include <pleura/nodes/deformable/chainmail/chainmail_model.h>

namespace pleura {
namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
constexpr float kInfinity = std::numeric_limits<float>::infinity();

ChainmailModel modelOf(const std::vector<ChainmailMaterial>& material) {
  const Points rest{{0, 0, 0}, {1, -2, 3}};
  return makeChainmailModel(rest, linkEdges(rest, std::vector<Eigen::Vector2i>{{0, 1}}), material);
}

TEST(ChainmailModel, GivesEachWayWhatTheMaterialSays) {
  const ChainmailModel model = modelOf({{0.25f, 1.5f, 0.125f}});
  // By hand, from compression d - s <= b - a - d <= stretch d + s; d = (1, -2, 3), s = (5, 4, 3) / 8.
  const ChainmailPull expected = (ChainmailPull() << 0.75f + 0.625f, 1.0f + 0.5f, 2.25f + 0.375f, 0,
                                  0.5f + 0.625f, 1.5f + 0.5f, 1.5f + 0.375f, 0)
                                     .finished();
  EXPECT_TRUE((model.slack[0] == expected).all()) << model.slack[0].transpose();
}

TEST(ChainmailModel, BothEndsOfALinkCount) {
  std::mt19937 random(1);
  std::uniform_real_distribution<float> ratio(0, 1);
  for (int trial = 0; trial < 100; ++trial) {
    const ChainmailMaterial a{ratio(random), 1 + ratio(random), ratio(random)};
    const ChainmailMaterial b{ratio(random), 1 + ratio(random), ratio(random)};
    const ChainmailModel ab = modelOf({a, b}), ba = modelOf({b, a});
    EXPECT_TRUE((ab.slack[0] == ba.slack[0]).all());
    EXPECT_TRUE((ab.slack[0].head<4>() == ab.slack[1].tail<4>()).all());
    EXPECT_TRUE((ab.slack[0].tail<4>() == ab.slack[1].head<4>()).all());
  }
}

TEST(ChainmailModel, ARigidEndHalvesTheSlackOfALink) {
  const ChainmailMaterial soft;
  const ChainmailPull mixed = modelOf({soft, kRigid}).slack[0], whole = modelOf({soft}).slack[0];
  EXPECT_TRUE(mixed.isApprox(0.5f * whole, 1e-6f));
  EXPECT_TRUE((modelOf({kRigid}).slack[0] == 0).all());
}

TEST(ChainmailModel, RefusesMaterialOutOfRangeAndNamesIt) {
  const std::vector<std::pair<ChainmailMaterial, const char*>> bad{
      {{1.5f, 1.25f, 0}, "compression"}, {{-0.1f, 1.25f, 0}, "compression"},
      {{kNan, 1.25f, 0}, "compression"}, {{0.5f, 0.75f, 0}, "stretch"},
      {{0.5f, kInfinity, 0}, "stretch"}, {{0.5f, kNan, 0}, "stretch"},
      {{0.5f, 1.25f, -1}, "shear"},      {{0.5f, 1.25f, kInfinity}, "shear"},
      {{0.5f, 1.25f, kNan}, "shear"}};
  for (const auto& [material, name] : bad) {
    try {
      modelOf({ChainmailMaterial{}, material});
      ADD_FAILURE() << name << " was accepted";
    } catch (const std::invalid_argument& error) {
      EXPECT_NE(std::string(error.what()).find(name), std::string::npos) << error.what();
      EXPECT_NE(std::string(error.what()).find("material 1"), std::string::npos) << error.what();
    }
  }
}

TEST(ChainmailModel, KeepsItsMaterialWhenAnotherIsRefused) {
  ChainmailModel model = modelOf({kDiaphragm});
  const std::vector<ChainmailPull> before = model.slack;
  EXPECT_THROW(setMaterial(model, std::vector<ChainmailMaterial>{{2, 1, 0}}), std::invalid_argument);
  EXPECT_THROW(setMaterial(model, std::vector<ChainmailMaterial>(3)), std::invalid_argument);
  EXPECT_TRUE((model.slack[0] == before[0]).all());
  setMaterial(model, std::vector<ChainmailMaterial>{kRigid});
  EXPECT_TRUE((model.slack[0] == 0).all());
}

TEST(ChainmailModel, EndlessStretchStaysFinite) {
  const ChainmailModel model =
      modelOf({{0, std::numeric_limits<float>::max(), std::numeric_limits<float>::max()}});
  EXPECT_LE(model.slack[0].maxCoeff(), 1e30f);
}

TEST(ChainmailModel, RefusesSizesThatDoNotFit) {
  const Points rest{{0, 0, 0}, {1, 0, 0}};
  const std::vector<ChainmailMaterial> one(1);
  EXPECT_THROW(makeChainmailModel(rest, linkEdges(Points{{0, 0, 0}}, {}), one), std::invalid_argument);
  EXPECT_THROW(makeChainmailModel(Points{{0, kNan, 0}}, linkEdges(Points{{0, 0, 0}}, {}), one),
               std::invalid_argument);
}

}  // namespace
}  // namespace pleura
