#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include <pleura/nodes/standard/interpolation/color_interpolator.h>
#include <pleura/nodes/standard/interpolation/coordinate_interpolator.h>
#include <pleura/nodes/standard/interpolation/key_interval.h>
#include <pleura/nodes/standard/interpolation/normal_interpolator.h>
#include <pleura/nodes/standard/interpolation/orientation_interpolator.h>
#include <pleura/nodes/standard/interpolation/position_interpolator.h>
#include <pleura/nodes/standard/interpolation/scalar_interpolator.h>
#include <pleura/tests/nodes/test_context.h>

namespace pleura {
namespace {

class Interpolators : public ::testing::Test {
 protected:
  template <class T>
  std::shared_ptr<T> make(std::vector<float> keys, decltype(T::keyValue.getValue()) values) {
    return context.make<T>([&](T& node) {
      node.key.setValue(keys);
      node.keyValue.setValue(values);
    });
  }
  template <class T>
  static auto at(T& node, float fraction) {
    node.set_fraction.setValue(fraction);
    return node.value_changed.getValue();
  }
  TestContext context;
};

TEST(KeyInterval, IsFoundAsByLinearSearch) {
  std::mt19937 random(1);
  std::uniform_real_distribution<float> number(0, 1);
  for (int run = 0; run < 200; ++run) {
    std::vector<float> keys(1 + random() % 9);
    for (auto& key : keys) key = std::round(10 * number(random)) / 10;
    std::sort(keys.begin(), keys.end());
    const float f = 1.4f * number(random) - 0.2f;
    std::size_t from = 0;
    while (from + 1 < keys.size() && keys[from + 1] <= f) ++from;
    const KeyInterval found = findKeyInterval(keys, f);
    EXPECT_EQ(found.from, from);
    EXPECT_GE(found.share, 0);
    EXPECT_LE(found.share, 1);
    if (found.share > 0) {
      EXPECT_NEAR(keys[from] + found.share * (keys[from + 1] - keys[from]), f, 1e-6);
    }
  }
}

TEST_F(Interpolators, GoInStraightLinesAndStayAtTheEnds) {
  const auto node = make<ScalarInterpolator>({0.2f, 0.4f, 0.8f}, {1, 3, -1});
  EXPECT_FLOAT_EQ(at(*node, 0.3f), 2);
  EXPECT_NEAR(at(*node, 0.7f), 0, 1e-6);
  EXPECT_FLOAT_EQ(at(*node, 0.4f), 3);
  EXPECT_EQ(at(*node, -5), 1);
  EXPECT_EQ(at(*node, 5), -1);
}

TEST_F(Interpolators, ComputeOnlyWhatIsRead) {
  const auto node = make<PositionInterpolator>({0, 1}, {Vec3f(0, 0, 0), Vec3f(2, 4, 6)});
  node->set_fraction.setValue(0.5f);
  EXPECT_FALSE(node->value_changed.isUpToDate());
  EXPECT_EQ(node->value_changed.getValue(), Vec3f(1, 2, 3));
}

TEST_F(Interpolators, JumpWhereKeysAreEqual) {
  const auto node = make<ScalarInterpolator>({0, 0.5f, 0.5f, 1}, {0, 1, 5, 6});
  EXPECT_FLOAT_EQ(at(*node, 0.25f), 0.5f);
  EXPECT_FLOAT_EQ(at(*node, 0.5f), 5);
}

TEST_F(Interpolators, TakeOneKeyOrNone) {
  EXPECT_EQ(at(*make<ScalarInterpolator>({0.5f}, {7}), 0.1f), 7);
  EXPECT_EQ(at(*make<ScalarInterpolator>({}, {}), 0.1f), 0);
  EXPECT_EQ(at(*make<PositionInterpolator>({}, {Vec3f(1, 1, 1)}), 0.1f), Vec3f(0, 0, 0));
}

TEST_F(Interpolators, WarnOnceOfUnsortedOrMissingKeys) {
  const auto missing = make<ScalarInterpolator>({0, 1}, {3});
  EXPECT_EQ(at(*missing, 0.5f), 3);
  EXPECT_EQ(at(*missing, 1), 3);
  EXPECT_EQ(context.warnings.size(), 1u);
  const auto unsorted = make<ScalarInterpolator>({0, 1, 0.5f, 0.2f}, {0, 1, 2, 3});
  for (float f = -0.5f; f < 1.5f; f += 0.05f) {
    EXPECT_GE(at(*unsorted, f), 0);
    EXPECT_LE(at(*unsorted, f), 3);
  }
  EXPECT_EQ(context.warnings.size(), 2u);
  const auto uneven = make<CoordinateInterpolator>({0, 1}, std::vector<Vec3f>(5, Vec3f(1, 2, 3)));
  EXPECT_EQ(at(*uneven, 0.5f).size(), 2u);
  EXPECT_EQ(context.warnings.size(), 3u);
}

TEST_F(Interpolators, TurnTheShorterWayAtAnEvenSpeed) {
  const auto node = make<OrientationInterpolator>({0, 1}, {Rotation(0, 1, 0, 0.2f), Rotation(0, 1, 0, 6.0f)});
  const float way = 2 * static_cast<float>(M_PI) - 5.8f;
  for (const float f : {0.25f, 0.5f, 0.75f}) {
    const auto turned = at(*node, f).quaternion();
    EXPECT_NEAR(Rotation(0, 1, 0, 0.2f).quaternion().angularDistance(turned), f * way, 1e-3);
    EXPECT_NEAR(turned.norm(), 1, 1e-6);
  }
  EXPECT_EQ(at(*node, 1), Rotation(0, 1, 0, 6.0f)) << "key values come out as they went in";
}

TEST_F(Interpolators, MoveNormalsAlongGreatCircles) {
  const auto node =
      make<NormalInterpolator>({0, 1}, {Vec3f(1, 0, 0), Vec3f(0, 0, 1), Vec3f(0, 1, 0), Vec3f(0, 0, -1)});
  const auto normals = at(*node, 1.0f / 3);
  ASSERT_EQ(normals.size(), 2u);
  EXPECT_NEAR(normals[0].x(), std::cos(M_PI / 6), 1e-5);
  EXPECT_NEAR(normals[0].y(), 0.5, 1e-5);
  for (const auto& normal : normals) EXPECT_NEAR(normal.norm(), 1, 1e-5);
}

TEST_F(Interpolators, MixColoursByHueTheShorterWay) {
  const auto node = make<ColorInterpolator>({0, 1}, {RGB(1, 0, 0), RGB(1, 0, 1)});
  EXPECT_LT((at(*node, 0.5f) - RGB(1, 0, 0.5f)).norm(), 1e-5) << "red to magenta does not pass through green";
  std::mt19937 random(5);
  std::uniform_real_distribution<float> number(0, 1);
  for (int i = 0; i < 100; ++i) {
    const RGB color(number(random), number(random), number(random));
    const auto same = make<ColorInterpolator>({0, 1}, {color, color});
    EXPECT_LT((at(*same, 0.5f) - color).norm(), 1e-5);
  }
  const auto gray = make<ColorInterpolator>({0, 1}, {RGB(0, 0, 0), RGB(0, 0, 1)});
  EXPECT_LT((at(*gray, 0.5f) - RGB(0.25f, 0.25f, 0.5f)).norm(), 1e-5) << "black takes the hue of blue";
}

TEST_F(Interpolators, ReuseTheirListOfPoints) {
  const auto node =
      make<CoordinateInterpolator>({0, 1}, {Vec3f(0, 0, 0), Vec3f(1, 0, 0), Vec3f(0, 2, 0), Vec3f(1, 2, 0)});
  node->set_fraction.setValue(0);
  const auto* data = node->value_changed.getValue().data();
  node->set_fraction.setValue(0.5f);
  EXPECT_EQ(node->value_changed.getValue()[1], Vec3f(1, 1, 0));
  EXPECT_EQ(node->value_changed.getValue().data(), data);
}

}  // namespace
}  // namespace pleura
