#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <stdexcept>

#include <fmt/format.h>
#include <png.h>

#include <pleura/x3d/browser/render/image.h>

namespace pleura::render {
namespace {

constexpr int maxSide = 16384;

[[noreturn]] void fail(const std::string& path, const std::string& why) {
  throw std::runtime_error(fmt::format("{}: {}", path, why));
}

png_image header(const Image& image) {
  png_image png{};
  png.version = PNG_IMAGE_VERSION;
  png.format = PNG_FORMAT_RGB;
  png.width = static_cast<png_uint_32>(image.width);
  png.height = static_cast<png_uint_32>(image.height);
  return png;
}

void paste(const Image& from, Image& to, int left, int top) {
  for (int y = 0; y < from.height; ++y) std::copy_n(from.at(0, y), 3 * from.width, to.at(left, top + y));
}

}  // namespace

Image makeImage(int width, int height, std::uint8_t red, std::uint8_t green, std::uint8_t blue) {
  if (width < 1 || height < 1 || width > maxSide || height > maxSide)
    throw std::invalid_argument(
        fmt::format("image of {} x {}: sides must be in [1, {}]", width, height, maxSide));
  Image image{width, height, std::vector<std::uint8_t>(static_cast<std::size_t>(width) * height * 3)};
  const std::uint8_t color[] = {red, green, blue};
  for (std::size_t i = 0; i < image.pixels.size(); ++i) image.pixels[i] = color[i % 3];
  return image;
}

void writePng(const Image& image, const std::string& path) {
  const std::string partial = path + ".part";
  png_image png = header(image);
  if (!png_image_write_to_file(&png, partial.c_str(), 0, image.pixels.data(), 0, nullptr)) {
    std::remove(partial.c_str());
    fail(path, png.message);
  }
  std::error_code error;
  std::filesystem::rename(partial, path, error);
  if (error) {
    std::remove(partial.c_str());
    fail(path, error.message());
  }
}

Image readPng(const std::string& path) {
  png_image png{};
  png.version = PNG_IMAGE_VERSION;
  if (!png_image_begin_read_from_file(&png, path.c_str())) fail(path, png.message);
  if (png.width > maxSide || png.height > maxSide) {
    png_image_free(&png);
    fail(path, "picture is too large");
  }
  png.format = PNG_FORMAT_RGB;
  Image image = makeImage(static_cast<int>(png.width), static_cast<int>(png.height));
  const png_color black{0, 0, 0};
  if (!png_image_finish_read(&png, &black, image.pixels.data(), 0, nullptr)) fail(path, png.message);
  return image;
}

Image contactSheet(std::span<const Image> images, int columns) {
  if (images.empty()) throw std::invalid_argument("contact sheet of no images");
  if (columns < 1) throw std::invalid_argument("contact sheet needs columns of at least 1");
  int cellWidth = 0, cellHeight = 0;
  for (const Image& image : images) {
    cellWidth = std::max(cellWidth, image.width);
    cellHeight = std::max(cellHeight, image.height);
  }
  const int count = static_cast<int>(images.size()), used = std::min(columns, count);
  Image sheet = makeImage(used * cellWidth, (count + used - 1) / used * cellHeight, 255, 255, 255);
  for (int i = 0; i < count; ++i)
    paste(images[static_cast<std::size_t>(i)], sheet, i % used * cellWidth, i / used * cellHeight);
  return sheet;
}

}  // namespace pleura::render
