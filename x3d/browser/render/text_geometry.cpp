#include <algorithm>
#include <cmath>
#include <map>

#include <pleura/x3d/browser/render/require.h>
#include <pleura/x3d/browser/render/tessellate.h>
#include <pleura/x3d/browser/render/text_geometry.h>

namespace pleura::render {
namespace {

float fraction(TextJustify justify) {
  return justify == TextJustify::Middle ? 0.5f : justify == TextJustify::End ? 1.0f : 0.0f;
}

struct Glyph {
  PlaneMesh mesh;  // [em]
  float advance;   // [em]
};

/// The glyphs met so far, each triangulated once.
class Glyphs {
 public:
  explicit Glyphs(const FontStyle& style) : font_(findFont(style.family, style.bold, style.italic)) {}

  const Glyph& operator[](char32_t codePoint) {
    const auto found = glyphs_.find(codePoint);
    if (found != glyphs_.end()) return found->second;
    const GlyphOutline outline = font_.outline(codePoint);
    return glyphs_.emplace(codePoint, Glyph{tessellate(outline.contours), outline.advance}).first->second;
  }
  const Font& font() const { return font_; }

 private:
  Font font_;
  std::map<char32_t, Glyph> glyphs_;
};

/// One line (a column where not horizontal) before it is placed.
struct Line {
  std::vector<char32_t> codePoints;
  float extent = 0;   // as the font has it [m]
  float stretch = 1;  // by length and maxExtent
};

float advance(const Glyph& glyph, const FontStyle& style) {
  return style.horizontal ? glyph.advance * style.size : style.size;
}

std::vector<Line> measure(const std::vector<std::string>& texts, const FontStyle& style,
                          const std::vector<float>& length, float maxExtent, Glyphs& glyphs) {
  std::vector<Line> lines(texts.size());
  float longest = 0;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    Line& line = lines[i];
    line.codePoints = decodeUtf8(texts[i]);
    for (const char32_t c : line.codePoints) line.extent += advance(glyphs[c], style);
    if (i < length.size() && length[i] > 0 && line.extent > 0) line.stretch = length[i] / line.extent;
    longest = std::max(longest, line.extent * line.stretch);
  }
  if (maxExtent > 0 && longest > maxExtent)
    for (Line& line : lines) line.stretch *= maxExtent / longest;
  return lines;
}

void append(const PlaneMesh& mesh, const Eigen::Vector2f& origin, const Eigen::Vector2f& scale,
            TextGeometry& text) {
  const auto first = static_cast<std::uint32_t>(text.positions.size());
  for (const Eigen::Vector2f& p : mesh.positions) {
    const Eigen::Vector2f q = origin + scale.cwiseProduct(p);
    text.positions.emplace_back(q.x(), q.y(), 0.0f);
  }
  for (const std::uint32_t i : mesh.indices) text.indices.push_back(first + i);
}

/// Base line of row `i` of `count`, by minor justification: FIRST puts the first base line at 0, BEGIN the
/// top of its glyphs, END the bottom of the last line's, MIDDLE the block's middle.
float baseLine(std::size_t i, std::size_t count, const FontStyle& style, const Font& font) {
  const float down = style.topToBottom ? -1.0f : 1.0f, pitch = style.size * style.spacing;
  const float last = down * pitch * static_cast<float>(count - 1);
  const float top = std::max(0.0f, last) + style.size * font.ascender();
  const float bottom = std::min(0.0f, last) + style.size * font.descender();
  const float begin = style.topToBottom ? top : bottom, end = style.topToBottom ? bottom : top;
  const float zero = style.minor == TextJustify::First ? 0.0f : begin + fraction(style.minor) * (end - begin);
  return down * pitch * static_cast<float>(i) - zero;
}

void placeRow(const Line& line, float y, const FontStyle& style, Glyphs& glyphs, TextGeometry& text) {
  const float direction = style.leftToRight ? 1.0f : -1.0f;
  float pen = -direction * fraction(style.major) * line.extent * line.stretch;
  for (const char32_t c : line.codePoints) {
    const float step = direction * advance(glyphs[c], style) * line.stretch;
    append(glyphs[c].mesh, {style.leftToRight ? pen : pen + step, y}, {style.size * line.stretch, style.size},
           text);
    pen += step;
  }
}

/// Left edge of column `i` of `count`; columns are as wide as the size.
float columnEdge(std::size_t i, std::size_t count, const FontStyle& style) {
  const float direction = style.leftToRight ? 1.0f : -1.0f, pitch = style.size * style.spacing;
  const float width = style.size + pitch * static_cast<float>(count - 1);
  const float begin = direction * (pitch * static_cast<float>(i) - fraction(style.minor) * width);
  return style.leftToRight ? begin : begin - style.size;
}

void placeColumn(const Line& line, float x, const FontStyle& style, Glyphs& glyphs, TextGeometry& text) {
  const float direction = style.topToBottom ? -1.0f : 1.0f;
  float pen = -direction * fraction(style.major) * line.extent * line.stretch;
  for (const char32_t c : line.codePoints) {
    const Glyph& glyph = glyphs[c];
    const float step = direction * style.size * line.stretch, bottom = std::min(pen, pen + step);
    const float height = style.size * line.stretch;
    append(glyph.mesh,
           {x + style.size * (1 - glyph.advance) / 2, bottom - height * glyphs.font().descender()},
           {style.size, height}, text);
    pen += step;
  }
}

void setBounds(const std::vector<Line>& lines, const FontStyle& style, TextGeometry& text) {
  Eigen::Vector2f bounds(0, 0);
  for (const Line& line : lines) {
    const float along = line.extent * line.stretch;
    text.lineBounds.push_back(style.horizontal ? Eigen::Vector2f(along, style.size)
                                               : Eigen::Vector2f(style.size, along));
    bounds = bounds.cwiseMax(text.lineBounds.back());
  }
  const float across = style.size * style.spacing * static_cast<float>(lines.empty() ? 0 : lines.size() - 1);
  text.textBounds = bounds + (style.horizontal ? Eigen::Vector2f(0, across) : Eigen::Vector2f(across, 0));
}

}  // namespace

TextGeometry textGeometry(const std::vector<std::string>& lines, const FontStyle& style,
                          const std::vector<float>& length, float maxExtent) {
  require(style.size > 0 && std::isfinite(style.size), "fontStyle.size must be above 0");
  require(style.spacing >= 0 && std::isfinite(style.spacing), "fontStyle.spacing must be at least 0");
  require(maxExtent >= 0 && std::isfinite(maxExtent), "text.maxExtent must be at least 0");
  for (const float value : length)
    require(value >= 0 && std::isfinite(value), "text.length must be at least 0");
  Glyphs glyphs(style);
  TextGeometry text;
  const std::vector<Line> measured = measure(lines, style, length, maxExtent, glyphs);
  for (std::size_t i = 0; i < measured.size(); ++i) {
    if (style.horizontal)
      placeRow(measured[i], baseLine(i, measured.size(), style, glyphs.font()), style, glyphs, text);
    else
      placeColumn(measured[i], columnEdge(i, measured.size(), style), style, glyphs, text);
  }
  setBounds(measured, style, text);
  return text;
}

}  // namespace pleura::render
