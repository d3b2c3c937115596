#include <cmath>
#include <limits>

#include "golden.h"
#include "shapes.h"
#include <gtest/gtest.h>

#include <pleura/x3d/browser/render/tessellate.h>
#include <pleura/x3d/browser/render/text_geometry.h>

namespace pleura::render::test {
namespace {

Eigen::AlignedBox3f bounds(const TextGeometry& text) {
  Eigen::AlignedBox3f box;
  for (const Eigen::Vector3f& p : text.positions) box.extend(p);
  return box;
}

FontStyle sans() {
  FontStyle style;
  style.family = FontFamily::Sans;
  return style;
}

double area(const PlaneMesh& mesh) {
  double sum = 0;
  for (std::size_t t = 0; t < mesh.indices.size(); t += 3) {
    const Eigen::Vector2f a = mesh.positions[mesh.indices[t]], b = mesh.positions[mesh.indices[t + 1]] - a,
                          c = mesh.positions[mesh.indices[t + 2]] - a;
    EXPECT_GE(b.x() * c.y() - b.y() * c.x(), 0) << "clockwise";
    sum += (b.x() * c.y() - b.y() * c.x()) / 2;
  }
  return sum;
}

TEST(Tessellate, HolesAreLeftOutAndOverlapsCountOnce) {
  const std::vector<Eigen::Vector2f> square{{0, 0}, {4, 0}, {4, 4}, {0, 4}},
      hole{{1, 1}, {1, 2}, {2, 2}, {2, 1}}, overlapping{{3, 3}, {5, 3}, {5, 5}, {3, 5}};
  EXPECT_NEAR(area(tessellate({square, hole})), 15, 1e-5);
  EXPECT_NEAR(area(tessellate({square, overlapping})), 16 + 4 - 1, 1e-5);
  EXPECT_TRUE(tessellate({}).indices.empty());
}

TEST(TextGeometry, FacesTheReaderAndScalesWithSize) {
  FontStyle style = sans();
  const TextGeometry small = textGeometry({"Rib 7"}, style);
  style.size = 3;
  const TextGeometry large = textGeometry({"Rib 7"}, style);
  ASSERT_EQ(small.positions.size(), large.positions.size());
  EXPECT_NEAR(large.textBounds.x(), 3 * small.textBounds.x(), 1e-4);
  EXPECT_NEAR(bounds(large).max().x(), 3 * bounds(small).max().x(), 1e-4);
  EXPECT_NEAR(bounds(small).max().y(), 0.76, 0.04);  // an ascender of DejaVu Sans, in ems
}

TEST(TextGeometry, MajorJustificationPlacesEachLine) {
  FontStyle style = sans();
  const float across = textGeometry({"lung"}, style).textBounds.x();
  const auto middle = [&](TextJustify justify, bool leftToRight) {
    style.major = justify;
    style.leftToRight = leftToRight;
    return bounds(textGeometry({"lung"}, style)).center().x();
  };
  EXPECT_NEAR(middle(TextJustify::Begin, true), across / 2, 0.05);
  EXPECT_NEAR(middle(TextJustify::Middle, true), 0, 0.05);
  EXPECT_NEAR(middle(TextJustify::End, true), -across / 2, 0.05);
  EXPECT_NEAR(middle(TextJustify::Begin, false), -across / 2, 0.05);
  EXPECT_NEAR(middle(TextJustify::End, false), across / 2, 0.05);
}

TEST(TextGeometry, MinorJustificationPlacesTheBlock) {
  FontStyle style = sans();
  const auto box = [&](TextJustify justify, bool topToBottom) {
    style.minor = justify;
    style.topToBottom = topToBottom;
    return bounds(textGeometry({"HH", "HH"}, style));
  };
  EXPECT_NEAR(box(TextJustify::First, true).min().y(), -1,
              1e-3);  // the first base line at 0, the second one below
  EXPECT_NEAR(box(TextJustify::First, false).min().y(), 0, 1e-3);
  EXPECT_LT(box(TextJustify::Begin, true).max().y(), 0);
  EXPECT_GT(box(TextJustify::Begin, false).min().y(), 0);
  EXPECT_GT(box(TextJustify::End, true).min().y(), 0);
  EXPECT_NEAR(box(TextJustify::Middle, true).center().y(), 0, 0.2);
}

TEST(TextGeometry, VerticalTextRunsDownOrUp) {
  FontStyle style = sans();
  style.horizontal = false;
  EXPECT_NEAR(bounds(textGeometry({"abcd"}, style)).center().y(), -2, 0.3);
  style.topToBottom = false;
  EXPECT_NEAR(bounds(textGeometry({"abcd"}, style)).center().y(), 2, 0.3);
  const TextGeometry twoColumns = textGeometry({"ab", "cd"}, style);
  EXPECT_GT(bounds(twoColumns).max().x(), 1);
  style.leftToRight = false;
  EXPECT_LT(bounds(textGeometry({"ab", "cd"}, style)).min().x(), -1);
}

TEST(TextGeometry, LengthStretchesAndMaxExtentSqueezes) {
  const TextGeometry text = textGeometry({"in", "inspiration"}, sans(), {5, 0}, 0);
  EXPECT_NEAR(text.lineBounds[0].x(), 5, 1e-4);
  const float longest = text.lineBounds[1].x();
  EXPECT_NEAR(textGeometry({"in", "inspiration"}, sans(), {}, longest / 2).lineBounds[1].x(), longest / 2,
              1e-4);
  EXPECT_NEAR(textGeometry({"in", "inspiration"}, sans(), {}, longest * 2).lineBounds[1].x(), longest, 1e-4);
}

TEST(TextGeometry, EmptyTextAndBadUtf8AreHarmless) {
  EXPECT_TRUE(textGeometry({}, sans()).indices.empty());
  EXPECT_TRUE(textGeometry({"", " "}, sans()).indices.empty());
  EXPECT_EQ(decodeUtf8("a\xC3\xA9\xE2\x82\xAC\xF0\x9F\xAB\x81"),
            (std::vector<char32_t>{U'a', 0xE9, 0x20AC, 0x1FAC1}));
  EXPECT_EQ(decodeUtf8("\xFFz"), (std::vector<char32_t>{0xFFFD, U'z'}));
  EXPECT_EQ(decodeUtf8("\xE2\x82"), (std::vector<char32_t>{0xFFFD}));
  EXPECT_EQ(decodeUtf8("\xC0\xAF").front(), 0xFFFDu);  // an overlong '/'
}

TEST(TextGeometry, BadValuesAreRefusedByName) {
  FontStyle style = sans();
  EXPECT_THROW(textGeometry({"x"}, style, {-1}), std::invalid_argument);
  EXPECT_THROW(textGeometry({"x"}, style, {}, std::numeric_limits<float>::quiet_NaN()),
               std::invalid_argument);
  style.size = 0;
  EXPECT_THROW(textGeometry({"x"}, style), std::invalid_argument);
  style = sans();
  style.spacing = std::numeric_limits<float>::infinity();
  EXPECT_THROW(textGeometry({"x"}, style), std::invalid_argument);
}

TEST(Golden, TextInTheSceneAndOverIt) {
  FontStyle style;
  style.italic = true;
  style.major = TextJustify::Middle;
  const TextGeometry text = textGeometry({"Pleura", "æ Ω 8 %"}, style);
  Shape shape;
  shape.positions = text.positions;
  shape.indices = text.indices;
  shape.refresh();
  DrawList list;
  list.background.skyColor = {{0.1f, 0.15f, 0.3f}};
  lookFrom(list, {-1.5f, 0, 4});
  list.items = {{&shape.geometry, translation(0, 0.2f, 0)}};
  list.items[0].material.diffuseColor = {1, 0.8f, 0.4f};
  list.overlay = {{"left\nsecond line", 8, 8, 16, {1, 1, 1, 1}, Justify::Begin},
                  {"in the middle", 160, 210, 18, {0.4f, 1, 0.5f, 1}, Justify::Middle},
                  {"V = 2.41 L", 312, 8, 14, {1, 0.6f, 0.6f, 0.7f}, Justify::End}};
  expectGolden(drawGolden(list), "text");
}

}  // namespace
}  // namespace pleura::render::test
