#include <fstream>
#include <iterator>

#include <gtest/gtest.h>

#include <pleura/tests/x3d/temporary_folder.h>
#include <pleura/x3d/browser/tradeoff/tier_figures.h>

namespace pleura {
namespace {

TierFigures figures(const char* organ, const char* method) {
  return {.organ = organ,
          .method = method,
          .elements = 480,
          .median = 0.0012,
          .p99 = 0.0034,
          .setUp = 0.5,
          .memory = 12e6,
          .converged = false,
          .error = {0.0005, 0.001, 0.008, -0.02, 0.0025, 0.0001}};
}

class FigureTableTest : public ::testing::Test {
 protected:
  TemporaryFolder folder;
  std::filesystem::path file = folder.path() / "tradeoff.csv";
};

TEST_F(FigureTableTest, WhatWasMeasuredIsReadBack) {
  FigureTable(file, "a scene").add(figures("LUNG", "linear FEM"));
  const FigureTable again(file, "a scene");
  ASSERT_EQ(again.all().size(), 1u);
  const TierFigures& read = again.all()[0];
  EXPECT_EQ(read.organ, "LUNG");
  EXPECT_EQ(read.method, "linear FEM");
  EXPECT_EQ(read.elements, 480);
  EXPECT_FALSE(read.converged);
  const TierFigures written = figures("LUNG", "linear FEM");
  EXPECT_NEAR(read.median, written.median, 1e-9);
  EXPECT_NEAR(read.p99, written.p99, 1e-9);
  EXPECT_NEAR(read.setUp, written.setUp, 1e-6);
  EXPECT_NEAR(read.memory, written.memory, 1);
  EXPECT_NEAR(read.error.rms, written.error.rms, 1e-9);
  EXPECT_NEAR(read.error.percentile95, written.error.percentile95, 1e-9);
  EXPECT_NEAR(read.error.most, written.error.most, 1e-9);
  EXPECT_NEAR(read.error.volume, written.error.volume, 1e-9);
  EXPECT_NEAR(read.error.gap, written.error.gap, 1e-9);
  EXPECT_NEAR(read.error.penetration, written.error.penetration, 1e-9);
}

TEST_F(FigureTableTest, HasWhatWasMeasuredAndNothingElse) {
  FigureTable table(file, "a scene");
  table.add(figures("LUNG", "linear FEM"));
  EXPECT_TRUE(table.has("LUNG", "linear FEM", 480));
  EXPECT_FALSE(table.has("LUNG", "linear FEM", 60));
  EXPECT_FALSE(table.has("LUNG", "springs", 480));
  EXPECT_FALSE(table.has("DIAPHRAGM", "linear FEM", 480));
}

TEST_F(FigureTableTest, ALineThatWasCutOffIsMeasuredAgain) {
  {
    FigureTable table(file, "a scene");
    table.add(figures("LUNG", "linear FEM"));
    table.add(figures("LUNG", "springs"));
  }
  std::filesystem::resize_file(file, std::filesystem::file_size(file) - 20);
  FigureTable table(file, "a scene");
  EXPECT_TRUE(table.has("LUNG", "linear FEM", 480));
  EXPECT_FALSE(table.has("LUNG", "springs", 480));
  table.add(figures("LUNG", "springs"));
  EXPECT_EQ(FigureTable(file, "a scene").all().size(), 2u);
}

TEST_F(FigureTableTest, FiguresOfAnotherSceneAreLeftOut) {
  FigureTable(file, "a scene").add(figures("LUNG", "linear FEM"));
  EXPECT_TRUE(FigureTable(file, "another scene").all().empty());
  EXPECT_TRUE(FigureTable(file, "a scene").all().empty()) << "it was begun anew";
}

TEST_F(FigureTableTest, AFileThatCantBeWrittenIsAnError) {
  EXPECT_THROW(FigureTable(folder.path() / "missing/tradeoff.csv", "a scene"), std::runtime_error);
}

TEST(TierFigures, OnlyWhatHasConvergedAndIsNoReferenceMayBeChosen) {
  TierFigures one = figures("LUNG", "linear FEM");
  EXPECT_FALSE(one.isChoosable());
  one.converged = true;
  EXPECT_TRUE(one.isChoosable());
  one.method = "reference";
  EXPECT_FALSE(one.isChoosable());
}

}  // namespace
}  // namespace pleura
