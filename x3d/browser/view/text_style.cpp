#include <algorithm>
#include <stdexcept>

#include <pleura/nodes/standard/text/font_style.h>
#include <pleura/x3d/browser/view/text_style.h>

namespace pleura {

namespace {

render::TextJustify justify(const std::vector<std::string>& words, std::size_t index,
                            render::TextJustify otherwise) {
  if (index >= words.size()) return otherwise;
  using enum render::TextJustify;
  if (words[index] == "FIRST") return First;
  if (words[index] == "BEGIN") return Begin;
  if (words[index] == "MIDDLE") return Middle;
  if (words[index] == "END") return End;
  return otherwise;
}

render::FontFamily family(const std::vector<std::string>& families) {
  for (const auto& each : families) {
    if (each == "SANS") return render::FontFamily::Sans;
    if (each == "TYPEWRITER") return render::FontFamily::Typewriter;
    if (each == "SERIF") return render::FontFamily::Serif;
  }
  return render::FontFamily::Serif;
}

render::FontStyle styleOf(FontStyle& node) {
  render::FontStyle style;
  style.family = family(node.family.getValue());
  const std::string& weight = node.style.getValue();
  style.bold = weight.find("BOLD") != std::string::npos;
  style.italic = weight.find("ITALIC") != std::string::npos;
  style.size = node.size.getValue();
  style.spacing = node.spacing.getValue();
  style.horizontal = node.horizontal.getValue();
  style.leftToRight = node.leftToRight.getValue();
  style.topToBottom = node.topToBottom.getValue();
  style.major = justify(node.justify.getValue(), 0, render::TextJustify::Begin);
  style.minor = justify(node.justify.getValue(), 1, render::TextJustify::First);
  return style;
}

/// Evaluates the fields first, so that the stamp stands for what is read.
std::uint64_t newest(Node& node) {
  std::uint64_t stamp = 0;
  for (const auto& declared : node.type().fields()) {
    Field& field = declared->of(node);
    field.upToDate();
    stamp = std::max(stamp, field.getStamp());
  }
  return stamp;
}

}  // namespace

std::uint64_t textStamp(Text& text) {
  auto* style = text.fontStyle.get();
  return std::max(newest(text), style != nullptr ? newest(*style) : 0);
}

render::TextGeometry layOut(Text& text) {
  auto* style = dynamic_cast<FontStyle*>(text.fontStyle.get());
  try {
    return render::textGeometry(text.string.getValue(),
                                style != nullptr ? styleOf(*style) : render::FontStyle(),
                                text.length.getValue(), text.maxExtent.getValue());
  } catch (const std::invalid_argument&) {
    return {};
  }
}

}  // namespace pleura
