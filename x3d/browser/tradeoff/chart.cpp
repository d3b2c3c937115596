#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <vector>

#include <fmt/format.h>

#include <pleura/fields/field_types.h>
#include <pleura/x3d/browser/tradeoff/chart.h>
#include <pleura/x3d/browser/tradeoff/deformation_tier.h>
#include <pleura/x3d/encoding/xml_text.h>

namespace pleura {

namespace {

using Point = std::array<double, 2>;

constexpr double kWidth = 800, kFieldHeight = 330;                   // px
constexpr double kLeft = 90, kRight = 180, kTop = 40, kBottom = 55;  // px around what is plotted
constexpr double kLeastCost = 1e-3, kLeastError = 1e-3;              // ms, mm: what is less is drawn there
const std::array<std::array<double, 3>, 7> kColours = {{{0.12, 0.35, 0.62},
                                                        {0.80, 0.36, 0.08},
                                                        {0.18, 0.52, 0.22},
                                                        {0.60, 0.13, 0.20},
                                                        {0.42, 0.27, 0.60},
                                                        {0.35, 0.35, 0.35},
                                                        {0.10, 0.55, 0.60}}};

/// What is drawn, in pixels from the upper left corner.
struct Drawing {
  struct Line {
    std::vector<Point> points;
    std::array<double, 3> colour;
    bool hasMarkers = false;
  };
  struct Label {
    Point at;
    std::string text;
    double size = 12;
    enum class Anchor { begin, middle, end } anchor = Anchor::begin;
    std::array<double, 3> colour{0.1, 0.1, 0.1};
  };
  double height = 0;
  std::vector<Line> lines;
  std::vector<Label> labels;
};

/// Decades from one number to another.
struct Scale {
  int from, to;  // exponents of ten
  double of(double x) const { return (std::log10(x) - from) / (to - from); }
};

Scale scaleOf(double least, double most) {
  const auto from = static_cast<int>(std::floor(std::log10(least)));
  const auto to = static_cast<int>(std::ceil(std::log10(most)));
  return {from, std::max(to, from + 1)};
}

std::vector<std::string> organsOf(std::span<const TierFigures> figures) {
  std::vector<std::string> organs;
  for (const auto& f : figures)
    if (std::find(organs.begin(), organs.end(), f.organ) == organs.end()) organs.push_back(f.organ);
  return organs;
}

double millisecondsOf(const TierFigures& f) { return std::max(1e3 * f.median, kLeastCost); }
double millimetresOf(const TierFigures& f) { return std::max(1e3 * f.error.rms, kLeastError); }

void drawField(std::span<const TierFigures> figures, const std::string& organ, double top, Drawing& drawing) {
  using enum Drawing::Label::Anchor;
  std::vector<const TierFigures*> shown;
  for (const auto& f : figures)
    if (f.organ == organ && f.method != kReferenceMethod) shown.push_back(&f);
  const auto byElements = [](auto* a, auto* b) { return a->elements < b->elements; };
  std::stable_sort(shown.begin(), shown.end(), byElements);
  const auto isFree = [](auto* f) { return f->median <= 0; };
  const auto costing = std::stable_partition(shown.begin(), shown.end(), isFree);
  if (costing == shown.end()) return;
  const auto byCost = [](auto* a, auto* b) { return millisecondsOf(*a) < millisecondsOf(*b); };
  const auto byError = [](auto* a, auto* b) { return millimetresOf(*a) < millimetresOf(*b); };
  const auto [cheap, dear] = std::minmax_element(costing, shown.end(), byCost);
  const auto [good, bad] = std::minmax_element(shown.begin(), shown.end(), byError);
  const Scale cost = scaleOf(millisecondsOf(**cheap), millisecondsOf(**dear)),
              error = scaleOf(millimetresOf(**good), millimetresOf(**bad));
  const double right = kWidth - kRight, bottom = top + kFieldHeight - kBottom;
  const auto place = [&](double ms, double mm) -> Point {
    return {kLeft + cost.of(ms) * (right - kLeft), bottom - error.of(mm) * (bottom - top - kTop)};
  };
  constexpr std::array<double, 3> kGrid{0.82, 0.82, 0.82};
  for (int e = cost.from; e <= cost.to; ++e) {
    const double x = place(std::pow(10, e), std::pow(10, error.from))[0];
    drawing.lines.push_back({{{x, top + kTop}, {x, bottom}}, kGrid});
    drawing.labels.push_back({{x, bottom + 16}, fmt::format("{:g}", std::pow(10, e)), 11, middle});
  }
  for (int e = error.from; e <= error.to; ++e) {
    const double y = place(std::pow(10, cost.from), std::pow(10, e))[1];
    drawing.lines.push_back({{{kLeft, y}, {right, y}}, kGrid});
    drawing.labels.push_back({{kLeft - 8, y + 4}, fmt::format("{:g}", std::pow(10, e)), 11, end});
  }
  drawing.labels.push_back({{kLeft, top + 24}, organ + ": error (RMS, mm) over cost (ms a shape)", 14});
  std::map<std::string, std::size_t> colourOf;
  for (const auto* f : shown) colourOf.try_emplace(f->method, colourOf.size());
  for (const auto& [method, number] : colourOf) {
    const auto& colour = kColours[number % kColours.size()];
    Drawing::Line line{{}, colour, true};
    for (const auto* f : shown) {
      if (f->method != method) continue;
      const Point at = place(millisecondsOf(*f), millimetresOf(*f));
      if (isFree(f))
        drawing.lines.push_back({{{kLeft, at[1]}, {right, at[1]}}, colour});
      else
        line.points.push_back(at);
    }
    if (!line.points.empty()) drawing.lines.push_back(line);
    drawing.labels.push_back(
        {{right + 16, top + kTop + 18 * (static_cast<double>(number) + 1)}, method, 12, begin, colour});
  }
}

Drawing drawingOf(std::span<const TierFigures> figures) {
  Drawing drawing;
  for (const auto& organ : organsOf(figures)) {
    drawField(figures, organ, drawing.height, drawing);
    drawing.height += kFieldHeight;
  }
  return drawing;
}

/// The corners of a square about a point, closed.
std::vector<Point> markerAt(const Point& p) {
  constexpr double kHalf = 3.5;
  return {{p[0] - kHalf, p[1] - kHalf},
          {p[0] + kHalf, p[1] - kHalf},
          {p[0] + kHalf, p[1] + kHalf},
          {p[0] - kHalf, p[1] + kHalf},
          {p[0] - kHalf, p[1] - kHalf}};
}

std::string hex(const std::array<double, 3>& c) {
  return fmt::format("#{:02x}{:02x}{:02x}", static_cast<int>(255 * c[0]), static_cast<int>(255 * c[1]),
                     static_cast<int>(255 * c[2]));
}

std::string svgLine(const std::vector<Point>& points, const std::array<double, 3>& colour) {
  std::string text = "<polyline fill='none' stroke-width='1.5' stroke='" + hex(colour) + "' points='";
  for (const auto& p : points) text += fmt::format("{:.1f},{:.1f} ", p[0], p[1]);
  return text + "'/>\n";
}

std::string sceneLine(const std::vector<Point>& points, const std::array<double, 3>& c) {
  std::string index, at;
  for (std::size_t i = 0; i < points.size(); ++i) {
    index += fmt::format("{} ", i);
    at += fmt::format("{:.2f} {:.2f} 0 ", points[i][0] / 100, -points[i][1] / 100);
  }
  return fmt::format(
      "<Shape><Appearance><Material diffuseColor='0 0 0' emissiveColor='{} {} {}'/></Appearance>"
      "<IndexedLineSet coordIndex='{}-1'><Coordinate point='{}'/></IndexedLineSet></Shape>\n",
      c[0], c[1], c[2], index, at);
}

/// An MFString of one, as an attribute.
std::string listOf(const std::string& text) {
  MFString list;
  list.setValue({text});
  return xmlText(list.getValueAsString());
}

template <class Draw>
std::string linesBy(const Drawing& drawing, Draw draw) {
  std::string text;
  for (const auto& line : drawing.lines) {
    text += draw(line.points, line.colour);
    if (!line.hasMarkers) continue;
    for (const auto& point : line.points) text += draw(markerAt(point), line.colour);
  }
  return text;
}

}  // namespace

std::string chartAsSvg(std::span<const TierFigures> figures) {
  const Drawing drawing = drawingOf(figures);
  constexpr std::array<const char*, 3> kAnchors{"start", "middle", "end"};
  std::string text = fmt::format(
      "<svg xmlns='http://www.w3.org/2000/svg' width='{0}' height='{1}' viewBox='0 0 {0} {1}' "
      "font-family='DejaVu Sans, sans-serif'>\n<rect width='100%' height='100%' fill='white'/>\n",
      kWidth, drawing.height);
  text += linesBy(drawing, svgLine);
  for (const auto& label : drawing.labels)
    text +=
        fmt::format("<text x='{:.1f}' y='{:.1f}' font-size='{}' text-anchor='{}' fill='{}'>{}</text>\n",
                    label.at[0], label.at[1], label.size, kAnchors[static_cast<std::size_t>(label.anchor)],
                    hex(label.colour), xmlText(label.text));
  return text + "</svg>\n";
}

std::string chartAsScene(std::span<const TierFigures> figures) {
  const Drawing drawing = drawingOf(figures);
  constexpr std::array<const char*, 3> kJustify{"BEGIN", "MIDDLE", "END"};
  std::string text = fmt::format(
      "<X3D version='4.0' profile='Immersive'><Scene><Background skyColor='1 1 1'/>"
      "<NavigationInfo headlight='false'/><OrthoViewpoint position='{0} {1} 10' fieldOfView='-{0} {1} {0} "
      "{2}'/>\n",
      kWidth / 200, -drawing.height / 200, drawing.height / 200);
  text += linesBy(drawing, sceneLine);
  for (const auto& label : drawing.labels)
    text += fmt::format(
        "<Transform translation='{:.2f} {:.2f} 0.01'><Shape><Appearance><Material diffuseColor='0 0 0' "
        "emissiveColor='{} {} {}'/></Appearance><Text string='{}'><FontStyle size='{}' family='\"SANS\"' "
        "justify='\"{}\"'/></Text></Shape></Transform>\n",
        label.at[0] / 100, -label.at[1] / 100, label.colour[0], label.colour[1], label.colour[2],
        listOf(label.text), label.size / 100, kJustify[static_cast<std::size_t>(label.anchor)]);
  return text + "</Scene></X3D>\n";
}

double chartAspect(std::span<const TierFigures> figures) { return drawingOf(figures).height / kWidth; }

}  // namespace pleura
