#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <Eigen/Core>

#include <pleura/x3d/browser/render/font.h>

namespace pleura::render {

enum class TextJustify { First, Begin, Middle, End };

/// X3D FontStyle.
struct FontStyle {
  FontFamily family = FontFamily::Serif;
  bool bold = false;
  bool italic = false;
  float size = 1;     // height of a line [m]
  float spacing = 1;  // distance of lines, in sizes
  bool horizontal = true;
  bool leftToRight = true;
  bool topToBottom = true;
  TextJustify major = TextJustify::Begin;  // along a line
  TextJustify minor = TextJustify::First;  // across lines
};

/// X3D Text as triangles in the plane z = 0, facing +Z.
struct TextGeometry {
  std::vector<Eigen::Vector3f> positions;   // [m]
  std::vector<std::uint32_t> indices;       // three a triangle
  std::vector<Eigen::Vector2f> lineBounds;  // width and height of each line [m]
  Eigen::Vector2f textBounds{0, 0};         // of all [m]
};

/// Lays out UTF-8 lines by X3D's rules (ISO/IEC 19775-1, 15.4.1). length[i] > 0 stretches line i to that
/// length, maxExtent > 0 squeezes all until none is longer [m]. Throws std::invalid_argument for a bad size,
/// spacing, length or maxExtent.
TextGeometry textGeometry(const std::vector<std::string>& lines, const FontStyle& style,
                          const std::vector<float>& length = {}, float maxExtent = 0);

}  // namespace pleura::render
