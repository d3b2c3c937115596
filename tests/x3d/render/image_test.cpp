#include <filesystem>
#include <fstream>
#include <random>
#include <stdexcept>

#include <gtest/gtest.h>

#include <pleura/x3d/browser/render/image.h>

namespace pleura::render {
namespace {

TEST(Image, PngKeepsEveryByte) {
  Image image = makeImage(37, 21);
  std::mt19937 random(3);
  for (std::uint8_t& byte : image.pixels) byte = static_cast<std::uint8_t>(random());
  const std::string path = ::testing::TempDir() + "pleura_image_test.png";
  writePng(image, path);
  const Image read = readPng(path);
  EXPECT_EQ(read.width, 37);
  EXPECT_EQ(read.height, 21);
  EXPECT_EQ(read.pixels, image.pixels);
  EXPECT_FALSE(std::filesystem::exists(path + ".part"));
  std::filesystem::remove(path);
}

TEST(Image, ErrorsNameTheFile) {
  const auto message = [](auto&& action) {
    try {
      action();
    } catch (const std::runtime_error& error) {
      return std::string(error.what());
    }
    return std::string("no error");
  };
  EXPECT_NE(message([] { writePng(makeImage(2, 2), "/nowhere/at/all.png"); }).find("/nowhere/at/all.png"),
            std::string::npos);
  EXPECT_NE(message([] { readPng("/nowhere/at/all.png"); }).find("/nowhere/at/all.png"), std::string::npos);
  const std::string path = ::testing::TempDir() + "pleura_not_a.png";
  std::ofstream(path) << "this is not a picture";
  EXPECT_NE(message([&] { readPng(path); }).find(path), std::string::npos);
  std::filesystem::remove(path);
}

TEST(Image, SidesAreChecked) {
  EXPECT_THROW(makeImage(0, 5), std::invalid_argument);
  EXPECT_THROW(makeImage(5, 1 << 20), std::invalid_argument);
}

TEST(ContactSheet, PutsImagesInRowsOnWhite) {
  const std::vector<Image> images{makeImage(4, 3, 255, 0, 0), makeImage(2, 3, 0, 255, 0),
                                  makeImage(4, 2, 0, 0, 255)};
  const Image sheet = contactSheet(images, 2);
  EXPECT_EQ(sheet.width, 8);
  EXPECT_EQ(sheet.height, 6);
  const auto color = [&](int x, int y) { return std::vector<int>(sheet.at(x, y), sheet.at(x, y) + 3); };
  EXPECT_EQ(color(3, 2), (std::vector<int>{255, 0, 0}));
  EXPECT_EQ(color(5, 0), (std::vector<int>{0, 255, 0}));
  EXPECT_EQ(color(6, 0), (std::vector<int>{255, 255, 255}));
  EXPECT_EQ(color(0, 3), (std::vector<int>{0, 0, 255}));
  EXPECT_EQ(color(4, 3), (std::vector<int>{255, 255, 255}));
  EXPECT_THROW(contactSheet({}, 2), std::invalid_argument);
  EXPECT_THROW(contactSheet(images, 0), std::invalid_argument);
}

}  // namespace
}  // namespace pleura::render
