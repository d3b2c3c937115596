#include <fmt/format.h>

#include <pleura/fields/range_text.h>

namespace pleura {

namespace {

std::string number(double x) { return fmt::format("{:.7g}", x); }

/// A range is inclusive: what is to be above 0 begins at the smallest number that is.
bool beginsAboveZero(const FieldDeclaration& d) {
  return d.minimum > 0 && d.minimum <= double{std::numeric_limits<float>::min()};
}

}  // namespace

std::string rangeText(const FieldDeclaration& d) {
  if (!d.isBounded()) return {};
  if (!std::isfinite(d.minimum)) return "at most " + number(d.maximum);
  std::string least = beginsAboveZero(d) ? "above 0" : "at least " + number(d.minimum);
  if (!std::isfinite(d.maximum)) return least;
  if (beginsAboveZero(d)) return least + ", at most " + number(d.maximum);
  return number(d.minimum) + " to " + number(d.maximum);
}

}  // namespace pleura
