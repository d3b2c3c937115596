#include <algorithm>
#include <array>
#include <sstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <pleura/tests/x3d/temporary_folder.h>
#include <pleura/x3d/browser/scene/scene.h>
#include <pleura/x3d/browser/tradeoff/chart.h>

namespace pleura {
namespace {

using testing::HasSubstr;
using testing::Not;

TierFigures tier(const std::string& organ, const char* method, double milliseconds, double millimetres) {
  TierFigures f;
  f.organ = organ;
  f.method = method;
  f.median = 1e-3 * milliseconds;
  f.error.rms = 1e-3 * millimetres;
  return f;
}

/// The corners of the first line of that colour, in pixels.
std::vector<std::array<double, 2>> pointsOf(const std::string& svg, const std::string& colour) {
  const std::string before = "stroke='" + colour + "' points='";
  const std::size_t begin = svg.find(before) + before.size();
  std::string text = svg.substr(begin, svg.find('\'', begin) - begin);
  std::replace(text.begin(), text.end(), ',', ' ');
  std::istringstream in(text);
  std::vector<std::array<double, 2>> points;
  for (double x = 0, y = 0; in >> x >> y;) points.push_back({x, y});
  return points;
}

TEST(Chart, DecadesAreEvenlySpacedBothWays) {
  const std::vector<TierFigures> figures{tier("LUNG", "linear FEM", 0.1, 10),
                                         tier("LUNG", "linear FEM", 1, 1),
                                         tier("LUNG", "linear FEM", 10, 0.1)};
  const auto points = pointsOf(chartAsSvg(figures), "#1e599e");
  ASSERT_EQ(points.size(), 3u);
  EXPECT_NEAR(points[1][0] - points[0][0], points[2][0] - points[1][0], 0.11);
  EXPECT_NEAR(points[1][1] - points[0][1], points[2][1] - points[1][1], 0.11);
  EXPECT_GT(points[1][0], points[0][0] + 50) << "cost grows to the right";
  EXPECT_GT(points[1][1], points[0][1] + 50) << "error grows upwards";
}

TEST(Chart, AFieldForEachOrganAndNoneForTheReference) {
  std::vector<TierFigures> figures{tier("LUNG", "linear FEM", 1, 1)};
  const double one = chartAspect(figures);
  figures.push_back(tier("DIAPHRAGM", "linear FEM", 1, 1));
  EXPECT_DOUBLE_EQ(chartAspect(figures), 2 * one);
  figures.push_back(tier("LUNG", "reference", 900, 0));
  EXPECT_DOUBLE_EQ(chartAspect(figures), 2 * one);
  EXPECT_THAT(chartAsSvg(figures), Not(HasSubstr("reference")));
}

TEST(Chart, ALineGoesFromTheCoarsestLatticeToTheFinest) {
  std::vector<TierFigures> figures{tier("LUNG", "linear FEM", 10, 0.1), tier("LUNG", "linear FEM", 0.1, 10)};
  figures[0].elements = 3840;
  figures[1].elements = 60;
  const auto points = pointsOf(chartAsSvg(figures), "#1e599e");
  ASSERT_EQ(points.size(), 2u);
  EXPECT_LT(points[0][0], points[1][0]);
}

TEST(Chart, WhatCostsNothingIsALineAcross) {
  const std::vector<TierFigures> figures{tier("LUNG", "smooth fill", 0, 2), tier("LUNG", "ChainMail", 1, 3)};
  const auto points = pointsOf(chartAsSvg(figures), "#1e599e");
  ASSERT_EQ(points.size(), 2u);
  EXPECT_GT(points[1][0], points[0][0] + 400);
  EXPECT_DOUBLE_EQ(points[1][1], points[0][1]);
  EXPECT_THAT(chartAsSvg(figures), HasSubstr(">smooth fill<"));
}

TEST(Chart, NamesOfOrgansAreTextWhateverTheyHold) {
  const std::vector<TierFigures> figures{tier("L<'&\"\\", "linear FEM", 1, 1)};
  EXPECT_THAT(chartAsSvg(figures), HasSubstr("L&lt;&apos;&amp;\"\\: error"));
  const TemporaryFolder folder;
  Scene scene;
  scene.load(folder.write("chart.x3d", chartAsScene(figures)));
  EXPECT_TRUE(scene.diagnostics().all().empty());
}

TEST(Chart, OfNothingIsEmpty) {
  EXPECT_EQ(chartAspect({}), 0);
  EXPECT_THAT(chartAsSvg({}), HasSubstr("</svg>"));
}

}  // namespace
}  // namespace pleura
