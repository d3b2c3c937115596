#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include <Eigen/Core>

namespace pleura::render {

enum class FontFamily { Serif, Sans, Typewriter };

/// The DejaVu font of that family and style. Throws std::runtime_error that names the file and the folders
/// looked in.
std::string findFont(FontFamily family, bool bold, bool italic);

/// The code points of UTF-8; U+FFFD for what is not UTF-8.
std::vector<char32_t> decodeUtf8(std::string_view text);

/// The filled shape of a glyph, in ems, from its origin on the base line.
struct GlyphOutline {
  std::vector<std::vector<Eigen::Vector2f>> contours;  // closed; the non-zero rule says what is inside
  float advance = 0;                                   // to the next glyph's origin
};

/// A line of text drawn in grey.
struct TextBitmap {
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> coverage;  // height * width, rows from the top
};

/// A font file opened with FreeType.
class Font {
 public:
  /// Throws std::runtime_error that names the file.
  explicit Font(const std::string& path);
  ~Font();
  Font(const Font&) = delete;
  Font& operator=(const Font&) = delete;

  GlyphOutline outline(char32_t codePoint) const;
  float ascender() const;   // of the tallest glyphs above the base line [em]
  float descender() const;  // of the deepest below, negative [em]

  /// Lines of text, parted by '\n', `size` pixels apart; justification 0 left, 0.5 middle, 1 right.
  TextBitmap rasterize(std::string_view text, int size, float justification) const;

 private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace pleura::render
