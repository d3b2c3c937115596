#include <algorithm>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include <pleura/nodes/thorax/motion/rib_motion.h>
#include <pleura/tests/nodes/chain/chain_scene.h>

namespace pleura {
namespace {

constexpr double kInhaled = 1, kExhaled = 3;  // [s] of a breath of 4
const std::vector<std::string> kOrgans = {"deformableDiaph", "deformableLL", "deformableRL"};

std::vector<Vec3f> shape(Scene& scene, const std::string& organ) {
  return valueOf<MFVec3f>(scene, organ + ".deformedCoord");
}

TEST(ChainThorax, LoadsWithoutFault) { EXPECT_EQ(toldBy(*chainThorax()), ""); }

TEST(ChainThorax, RibsTurnByTheThesisAngles) {
  const auto scene = chainThorax();
  scene->tick(kInhaled);
  for (const auto& [side, sign] : {std::pair("LEFT", 1.), {"RIGHT", -1.}}) {
    const auto angles = thesisRibAngles(sign);
    for (std::size_t number = 1; number <= 11; ++number) {
      const std::string name = side + (" RIB" + std::to_string(number));
      const auto rotation = valueOf<SFRotation>(*scene, name + ".rotation").quaternion();
      const Eigen::Matrix3f expected = ribRotation(angles[number - 1], 1).cast<float>();
      EXPECT_LT((rotation.toRotationMatrix() - expected).norm(), 1e-5f) << name;
    }
  }
  const Eigen::Matrix3f sternum = ribRotation({0.15, 0, 0}, 1).cast<float>();
  EXPECT_LT(
      (valueOf<SFRotation>(*scene, "STERNUM.rotation").quaternion().toRotationMatrix() - sternum).norm(),
      1e-5f);
}

/// How far from its place beside the point it follows the farthest of an organ's points is that a contact
/// names.
float farthestFromFollowed(Scene& scene, const std::string& touch, const std::string& leader,
                           const std::string& followedField, const std::string& organ) {
  const auto pairs = valueOf<MFInt32>(scene, touch + ".touch");
  const auto rest1 = valueOf<MFVec3f>(scene, touch + ".coord1");
  const auto rest2 = valueOf<MFVec3f>(scene, organ + ".origCoord");
  const auto followed = valueOf<MFVec3f>(scene, leader + "." + followedField);
  const auto now = shape(scene, organ);
  EXPECT_GT(pairs.size(), 0u) << touch;
  EXPECT_EQ(followed.size(), pairs.size() / 2) << "one contact node a rib";
  if (followed.size() != pairs.size() / 2) return INFINITY;
  float farthest = 0;
  for (std::size_t k = 0; k < followed.size(); ++k) {
    const auto first = static_cast<std::size_t>(pairs[2 * k]),
               second = static_cast<std::size_t>(pairs[2 * k + 1]);
    const Vec3f expected = rest2[second] + followed[k] - rest1[first];
    farthest = std::max(farthest, (now[second] - expected).norm());
  }
  return farthest;
}

TEST(ChainThorax, DrivenPointsFollowTheirRibs) {
  const auto scene = chainThorax();
  constexpr float kRounding = 1e-5f;  // [cm]
  for (const double time : {0., kInhaled, 1.7, kExhaled}) {
    scene->tick(time);
    for (const auto& [touch, leader] : {std::pair("TOUCH_L10_D", "LEFT RIB10"),
                                        {"TOUCH_R10_D", "RIGHT RIB10"},
                                        {"TOUCH_L11_D", "LEFT RIB11"},
                                        {"TOUCH_R11_D", "RIGHT RIB11"}})
      EXPECT_LT(farthestFromFollowed(*scene, touch, leader, "rib_points", "deformableDiaph"), kRounding)
          << touch << " at " << time;
    EXPECT_LT(farthestFromFollowed(*scene, "TOUCH_L2_LL", "LEFT RIB2", "rib_points", "deformableLL"),
              kRounding);
    EXPECT_LT(farthestFromFollowed(*scene, "TOUCH_R2_RL", "RIGHT RIB2", "rib_points", "deformableRL"),
              kRounding);
  }
}

TEST(ChainThorax, EveryContactNodeFindsContacts) {
  const auto scene = chainThorax();
  int count = 0;
  for (const auto& [name, node] : scene->document().names) {
    if (!name.starts_with("TOUCH")) continue;
    ++count;
    EXPECT_GT(valueOf<MFInt32>(*scene, name + ".touch").size(), 0u) << name;
  }
  EXPECT_EQ(count, 12);
}

TEST(ChainThorax, TheDomeGoesDownAndLungsFillOnInspiration) {
  const auto scene = chainThorax();
  scene->tick(kInhaled);
  const auto inhaled = shape(*scene, "deformableDiaph");
  const float left = valueOf<SFFloat>(*scene, "deformableLL.volume");
  const float right = valueOf<SFFloat>(*scene, "deformableRL.volume");
  scene->tick(kExhaled);
  const auto exhaled = shape(*scene, "deformableDiaph");
  const auto dome = static_cast<std::size_t>(valueOf<MFInt32>(*scene, "deformableDiaph.dome").at(0));
  EXPECT_NEAR(exhaled[dome].y() - inhaled[dome].y(), 2, 1e-5) << "cm, vertical";
  EXPECT_EQ(exhaled[dome].x(), inhaled[dome].x());
  // cm^3 of a lung: a breath of 0.4 to 0.7 L in both
  const float filled = left - valueOf<SFFloat>(*scene, "deformableLL.volume") + right -
                       valueOf<SFFloat>(*scene, "deformableRL.volume");
  EXPECT_GT(filled, 400);
  EXPECT_LT(filled, 700);
}

TEST(ChainThorax, TheTendonMovesAsOne) {
  const auto scene = chainThorax();
  scene->tick(kInhaled);
  const auto rest = valueOf<MFVec3f>(*scene, "deformableDiaph.origCoord");
  const auto now = shape(*scene, "deformableDiaph");
  const auto tendon = valueOf<MFInt32>(*scene, "deformableDiaph.rigid_points");
  ASSERT_GT(tendon.size(), 10u);
  for (const int point : tendon) {
    const auto i = static_cast<std::size_t>(point);
    EXPECT_LT((now[i] - rest[i] - Vec3f(0, -2, 0)).norm(), 1e-4f) << point;
  }
}

TEST(ChainThorax, ABreathIsFiniteAndReturnsToRest) {
  const auto scene = chainThorax();
  for (int k = 0; k <= 24; ++k) {
    scene->tick(k / 6.);
    for (const auto& organ : kOrgans)
      for (const auto& p : shape(*scene, organ)) ASSERT_TRUE(p.allFinite()) << organ << " at " << k;
  }
  scene->tick(4 + kExhaled);
  for (const auto& organ : kOrgans) {
    const auto rest = valueOf<MFVec3f>(*scene, organ + ".origCoord");
    const auto now = shape(*scene, organ);
    for (std::size_t i = 0; i < rest.size(); ++i)
      ASSERT_LT((now[i] - rest[i]).norm(), 1e-5f) << organ << " " << i;
  }
  EXPECT_EQ(toldBy(*scene), "");
}

}  // namespace
}  // namespace pleura
