#include <array>
#include <stdexcept>

#include <gtest/gtest.h>

#include <pleura/nodes/thorax/anatomy/measurements.h>
#include <pleura/nodes/thorax/anatomy/table.h>

namespace pleura {
namespace {

constexpr std::array<std::string_view, 3> kLines{"name,x_mm,y_mm,z_mm", "a,-1.15,-100,1200",
                                                 "b,98.85,-200,1300"};

TEST(Table, TurnsPointsIntoTheSubjectsFrame) {
  const Table table("test", kLines);
  ASSERT_EQ(table.rows(), 2u);
  EXPECT_EQ(table.text(1, "name"), "b");
  EXPECT_LT(table.point(0, "").norm(), 1e-12);
  EXPECT_LT((table.point(1, "") - Eigen::Vector3d(0.1, 0.1, 0.1)).norm(), 1e-12);
}

TEST(Table, RefusesWhatItCannotRead) {
  const Table table("test", kLines);
  EXPECT_THROW(table.number(0, "width_mm"), std::invalid_argument);
  EXPECT_THROW(table.number(0, "name"), std::invalid_argument);
  EXPECT_THROW(measurementTable("no such table"), std::invalid_argument);
  constexpr std::array<std::string_view, 2> ragged{"a,b", "1"};
  EXPECT_THROW(Table("ragged", ragged), std::invalid_argument);
  constexpr std::array<std::string_view, 2> infinite{"a,b", "1,inf"};
  EXPECT_THROW(Table("infinite", infinite).number(0, "b"), std::invalid_argument);
}

TEST(Table, HasEveryMeasurementOnce) {
  EXPECT_EQ(measurementTable("ribs").rows(), 384u);
  EXPECT_EQ(measurementTable("cartilages").rows(), 120u);
  EXPECT_EQ(measurementTable("diaphragm").rows(), 384u);
  EXPECT_EQ(measurementTable("vertebrae").rows(), 12u);
}

}  // namespace
}  // namespace pleura
