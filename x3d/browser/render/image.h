#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace pleura::render {

/// A picture of 8-bit RGB, rows from the top.
struct Image {
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> pixels;  // height * width * 3

  /// The three bytes of a pixel; (0, 0) is the top left corner. The caller keeps x and y inside.
  std::uint8_t* at(int x, int y) { return pixels.data() + 3 * (static_cast<std::size_t>(y) * width + x); }
  const std::uint8_t* at(int x, int y) const { return const_cast<Image*>(this)->at(x, y); }
};

/// A picture of one colour. Throws std::invalid_argument for a side below 1 or above 16384.
Image makeImage(int width, int height, std::uint8_t red = 0, std::uint8_t green = 0, std::uint8_t blue = 0);

/// Writes a PNG under a temporary name and renames it, so that a reader never sees half a file.
/// Throws std::runtime_error that names the file.
void writePng(const Image& image, const std::string& path);

/// Reads any PNG as RGB; alpha is dropped. Throws std::runtime_error that names the file.
Image readPng(const std::string& path);

/// The images in rows of `columns`, on white, each cell as large as the largest image.
/// Throws std::invalid_argument when there is no image or no column.
Image contactSheet(std::span<const Image> images, int columns);

}  // namespace pleura::render
