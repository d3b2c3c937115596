#include <algorithm>
#include <cmath>
#include <filesystem>
#include <stdexcept>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <ft2build.h>

#include <pleura/x3d/browser/render/font.h>
#include FT_FREETYPE_H
#include FT_OUTLINE_H

namespace pleura::render {
namespace {

const std::vector<std::string> fontFolders = {"/usr/share/fonts/truetype/dejavu", "/usr/share/fonts/dejavu",
                                              "/usr/share/fonts/TTF", "/usr/local/share/fonts"};

std::string fontFile(FontFamily family, bool bold, bool italic) {
  const char* const names[] = {"DejaVuSerif", "DejaVuSans", "DejaVuSansMono"};
  const std::string slant = !italic ? "" : family == FontFamily::Serif ? "Italic" : "Oblique";
  const std::string style = (bold ? "Bold" : "") + slant;
  return names[static_cast<int>(family)] + (style.empty() ? "" : "-" + style) + ".ttf";
}

/// Length of the UTF-8 sequence that starts with `lead`; 0 if none does.
std::size_t sequenceLength(unsigned char lead) {
  return lead < 0x80                   ? 1
         : lead >= 0xC2 && lead < 0xE0 ? 2
         : lead >= 0xE0 && lead < 0xF0 ? 3
         : lead >= 0xF0 && lead < 0xF5 ? 4
                                       : 0;
}

constexpr int curveSteps = 6;
constexpr int maxBitmapSide = 8192;  // as wide as any picture

/// Takes FreeType's walk along an outline, with curves as chords.
struct Walk {
  std::vector<std::vector<Eigen::Vector2f>>& contours;
  float scale;

  Eigen::Vector2f point(const FT_Vector* v) const {
    return {static_cast<float>(v->x) * scale, static_cast<float>(v->y) * scale};
  }
  void curve(const Eigen::Vector2f& b, const Eigen::Vector2f& c, const Eigen::Vector2f& d) const {
    const Eigen::Vector2f a = contours.back().back();
    for (int i = 1; i <= curveSteps; ++i) {
      const float t = static_cast<float>(i) / curveSteps, s = 1 - t;
      contours.back().push_back(s * s * s * a + 3 * s * s * t * b + 3 * s * t * t * c + t * t * t * d);
    }
  }
  static Walk& self(void* user) { return *static_cast<Walk*>(user); }
  static int moveTo(const FT_Vector* to, void* user) {
    self(user).contours.push_back({self(user).point(to)});
    return 0;
  }
  static int lineTo(const FT_Vector* to, void* user) {
    self(user).contours.back().push_back(self(user).point(to));
    return 0;
  }
  static int conicTo(const FT_Vector* control, const FT_Vector* to, void* user) {
    const Walk& walk = self(user);
    const Eigen::Vector2f a = walk.contours.back().back(), b = walk.point(control), c = walk.point(to);
    walk.curve(a + 2.0f / 3 * (b - a), c + 2.0f / 3 * (b - c), c);
    return 0;
  }
  static int cubicTo(const FT_Vector* b, const FT_Vector* c, const FT_Vector* to, void* user) {
    self(user).curve(self(user).point(b), self(user).point(c), self(user).point(to));
    return 0;
  }
};

std::vector<std::vector<char32_t>> splitLines(std::string_view text) {
  std::vector<std::vector<char32_t>> lines(1);
  for (const char32_t c : decodeUtf8(text)) {
    if (c == U'\n')
      lines.emplace_back();
    else
      lines.back().push_back(c);
  }
  return lines;
}

}  // namespace

std::string findFont(FontFamily family, bool bold, bool italic) {
  const std::string file = fontFile(family, bold, italic);
  for (const std::string& folder : fontFolders)
    if (const auto path = std::filesystem::path(folder) / file; std::filesystem::exists(path))
      return path.string();
  throw std::runtime_error(
      fmt::format("text needs the font {}, which is not in {}", file, fmt::join(fontFolders, ", ")));
}

std::vector<char32_t> decodeUtf8(std::string_view text) {
  std::vector<char32_t> result;
  for (std::size_t i = 0; i < text.size();) {
    const auto lead = static_cast<unsigned char>(text[i]);
    const std::size_t length = sequenceLength(lead);
    char32_t c = length < 2 ? lead : lead & (0x7Fu >> length);
    std::size_t read = 1;
    for (; read < length && i + read < text.size() &&
           (static_cast<unsigned char>(text[i + read]) & 0xC0) == 0x80;
         ++read)
      c = c << 6 | (static_cast<unsigned char>(text[i + read]) & 0x3F);
    const bool whole = read == length && !(length == 3 && (c < 0x800 || (c >= 0xD800 && c < 0xE000))) &&
                       !(length == 4 && (c < 0x10000 || c > 0x10FFFF));
    result.push_back(whole ? c : U'\uFFFD');
    i += read;
  }
  return result;
}

struct Font::Implementation {
  FT_Library library = nullptr;
  FT_Face face = nullptr;

  ~Implementation() { FT_Done_FreeType(library); }  // its faces go with it

  int lineWidth(const std::vector<char32_t>& line) const;
  void drawLine(const std::vector<char32_t>& line, int penX, int baseY, TextBitmap& bitmap) const;
};

Font::Font(const std::string& path) : implementation_(std::make_unique<Implementation>()) {
  if (FT_Init_FreeType(&implementation_->library) != 0) throw std::runtime_error("FreeType does not start");
  if (FT_New_Face(implementation_->library, path.c_str(), 0, &implementation_->face) != 0)
    throw std::runtime_error(path + ": not a font that FreeType reads");
  if (!FT_IS_SCALABLE(implementation_->face)) throw std::runtime_error(path + ": a font without outlines");
}

Font::~Font() = default;

GlyphOutline Font::outline(char32_t codePoint) const {
  const FT_Face face = implementation_->face;
  GlyphOutline result;
  if (FT_Load_Char(face, codePoint, FT_LOAD_NO_SCALE) != 0) return result;
  const float scale = 1 / static_cast<float>(face->units_per_EM);
  Walk walk{result.contours, scale};
  const FT_Outline_Funcs functions{Walk::moveTo, Walk::lineTo, Walk::conicTo, Walk::cubicTo, 0, 0};
  FT_Outline_Decompose(&face->glyph->outline, &functions, &walk);
  result.advance = static_cast<float>(face->glyph->metrics.horiAdvance) * scale;
  return result;
}

float Font::ascender() const {
  return static_cast<float>(implementation_->face->ascender) /
         static_cast<float>(implementation_->face->units_per_EM);
}

float Font::descender() const {
  return static_cast<float>(implementation_->face->descender) /
         static_cast<float>(implementation_->face->units_per_EM);
}

int Font::Implementation::lineWidth(const std::vector<char32_t>& line) const {
  FT_Pos width = 0;
  for (const char32_t c : line)
    if (FT_Load_Char(face, c, FT_LOAD_DEFAULT) == 0) width += face->glyph->advance.x;
  return static_cast<int>((width + 63) / 64);
}

void Font::Implementation::drawLine(const std::vector<char32_t>& line, int penX, int baseY,
                                    TextBitmap& bitmap) const {
  FT_Pos pen = FT_Pos{64} * penX;
  for (const char32_t c : line) {
    if (FT_Load_Char(face, c, FT_LOAD_RENDER) != 0) continue;
    const FT_GlyphSlot glyph = face->glyph;
    const int left = static_cast<int>(pen / 64) + glyph->bitmap_left, top = baseY - glyph->bitmap_top;
    for (int y = 0; y < static_cast<int>(glyph->bitmap.rows); ++y)
      for (int x = 0; x < static_cast<int>(glyph->bitmap.width); ++x) {
        if (left + x < 0 || left + x >= bitmap.width || top + y < 0 || top + y >= bitmap.height) continue;
        std::uint8_t& to = bitmap.coverage[static_cast<std::size_t>(top + y) * bitmap.width + left + x];
        to = std::max(to, glyph->bitmap.buffer[y * glyph->bitmap.pitch + x]);
      }
    pen += glyph->advance.x;
  }
}

TextBitmap Font::rasterize(std::string_view text, int size, float justification) const {
  // A line holds ascender and descender, so the em is smaller than the distance of lines.
  const float em = static_cast<float>(size) / (ascender() - descender());
  FT_Set_Char_Size(implementation_->face, 0, std::lround(64 * em), 72, 72);
  const auto lines = splitLines(text);
  std::vector<int> widths;
  widths.reserve(lines.size());
  for (const auto& line : lines) widths.push_back(implementation_->lineWidth(line));
  constexpr int margin = 2;  // glyphs may reach past their advance
  TextBitmap bitmap;
  bitmap.width = std::min(*std::ranges::max_element(widths) + 2 * margin, maxBitmapSide);
  bitmap.height = std::min(size * static_cast<int>(lines.size()), maxBitmapSide);
  bitmap.coverage.assign(static_cast<std::size_t>(bitmap.width) * bitmap.height, 0);
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const float slack = static_cast<float>(bitmap.width - 2 * margin - widths[i]);
    const int baseY =
        static_cast<int>(std::lround(static_cast<float>(size) * static_cast<float>(i) + em * ascender()));
    implementation_->drawLine(lines[i], margin + static_cast<int>(justification * slack), baseY, bitmap);
  }
  return bitmap;
}

}  // namespace pleura::render
