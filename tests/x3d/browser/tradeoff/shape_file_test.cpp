#include <limits>

#include <gtest/gtest.h>

#include <pleura/tests/x3d/temporary_folder.h>
#include <pleura/x3d/browser/tradeoff/shape_file.h>

namespace pleura {
namespace {

class ShapeFile : public ::testing::Test {
 protected:
  TemporaryFolder folder;
  std::filesystem::path file = folder.path() / "shapes.bin";
  std::vector<std::vector<Vec3f>> shapes{{{1, 2, 3}, {0.1f, -4, 1e-9f}}, {{5, 6, 7}, {8, 9, 10}}};
};

TEST_F(ShapeFile, GivesBackTheSameBits) {
  writeShapes(file, shapes);
  EXPECT_EQ(readShapes(file, 2, 2), shapes);
}

TEST_F(ShapeFile, OfAnotherSizeIsNone) {
  writeShapes(file, shapes);
  EXPECT_FALSE(readShapes(file, 2, 3));
  EXPECT_FALSE(readShapes(file, 1, 2));
  EXPECT_FALSE(readShapes(folder.path() / "missing.bin", 2, 2));
}

TEST_F(ShapeFile, WithWhatIsNoNumberIsNone) {
  shapes[1][0].y() = std::numeric_limits<float>::quiet_NaN();
  writeShapes(file, shapes);
  EXPECT_FALSE(readShapes(file, 2, 2));
}

TEST_F(ShapeFile, ThatCantBeWrittenIsAnError) {
  EXPECT_THROW(writeShapes(folder.path() / "missing/shapes.bin", shapes), std::runtime_error);
}

}  // namespace
}  // namespace pleura
