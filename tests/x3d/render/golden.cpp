#include "golden.h"

#include <algorithm>
#include <cmath>
#include <filesystem>

#include <gtest/gtest.h>

#include <pleura/x3d/browser/render/renderer.h>

namespace pleura::render::test {
namespace {

constexpr int tile = 16;

double tileMean(const Image& a, const Image& b, int left, int top) {
  const int right = std::min(left + tile, a.width), bottom = std::min(top + tile, a.height);
  double sum = 0;
  for (int y = top; y < bottom; ++y)
    for (int i = 3 * left; i < 3 * right; ++i) sum += std::abs(a.at(0, y)[i] - b.at(0, y)[i]);
  return sum / (3.0 * (right - left) * (bottom - top));
}

}  // namespace

Difference difference(const Image& a, const Image& b) {
  Difference d;
  for (std::size_t i = 0; i < a.pixels.size(); ++i) d.mean += std::abs(a.pixels[i] - b.pixels[i]);
  d.mean /= static_cast<double>(a.pixels.size());
  for (int top = 0; top < a.height; top += tile)
    for (int left = 0; left < a.width; left += tile)
      d.maxTile = std::max(d.maxTile, tileMean(a, b, left, top));
  return d;
}

Image drawGolden(const DrawList& list) {
  const auto context = makeOffscreenContext(OffscreenBackend::Osmesa);
  Renderer renderer(*context);
  renderer.draw(list, 320, 240);
  return renderer.readImage();
}

void expectGolden(const Image& image, const std::string& name) {
  const std::string golden = PLEURA_SOURCE_DIR "/tests/x3d/render/golden/" + name + ".png";
  const std::string actual = ::testing::TempDir() + name + ".actual.png";
  writePng(image, actual);
  ASSERT_TRUE(std::filesystem::exists(golden))
      << "no " << golden << "; look at " << actual << " and keep it if right";
  const Image expected = readPng(golden);
  ASSERT_EQ(image.width, expected.width);
  ASSERT_EQ(image.height, expected.height);
  const Difference d = difference(image, expected);
  EXPECT_LE(d.mean, 0.5) << actual;
  EXPECT_LE(d.maxTile, 4) << actual;
  if (!::testing::Test::HasFailure()) std::filesystem::remove(actual);
}

}  // namespace pleura::render::test
