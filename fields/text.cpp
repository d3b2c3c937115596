#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <fmt/format.h>

#include <pleura/fields/text.h>

namespace pleura {

namespace {

bool endsToken(const char* at, const char* end) {
  return at == end || *at == ' ' || *at == ',' || *at == '\n' || *at == '\t' || *at == '\r';
}

}  // namespace

template <class Number>
void TextReader::readNumber(Number& value, const char* expected) {
  skipSpace();
  if (at_ == end_ && numbersAValue_ > 1) failShort();
  const bool hasPlus = end_ - at_ > 1 && at_[0] == '+' && at_[1] != '-';
  Number number{};
  auto [to, error] = std::from_chars(hasPlus ? at_ + 1 : at_, end_, number);
  if constexpr (std::is_same_v<Number, float>)
    if (error == std::errc::result_out_of_range && readTiny(number)) error = std::errc();
  if (error != std::errc() || !endsToken(to, end_)) fail(expected);
  if constexpr (std::is_floating_point_v<Number>) {
    constexpr double kLargest = std::numeric_limits<Number>::max();
    if (!std::isfinite(number) || std::abs(number) > kLargest / std::max(1.0, std::abs(scale_)))
      fail(expected);
    number = static_cast<Number>(number * scale_);
  }
  at_ = to;
  value = number;
  ++numbers_;
}

/// The text ends within a value of several numbers.
void TextReader::failShort() const {
  const char* of = numbers_ > numbersAValue_ ? "a multiple of " : "";
  throw FieldParseError(fmt::format("{}{} numbers", of, numbersAValue_), offset(), fmt::to_string(numbers_));
}

void TextReader::expectEnd() {
  if (atEnd()) return;
  fail(numbersAValue_ > 1 ? fmt::format("nothing more after {} numbers", numbersAValue_) : "nothing more");
}

/// A number too near to zero for a float, which other programs write from doubles.
bool TextReader::readTiny(float& value) const {
  double wide = HUGE_VAL;
  std::from_chars(*at_ == '+' ? at_ + 1 : at_, end_, wide);
  value = std::abs(wide) < 1 ? static_cast<float>(wide) : 0;
  return std::abs(wide) < 1;
}

void TextReader::read(float& value) { readNumber(value, "a finite number"); }
void TextReader::read(double& value) { readNumber(value, "a finite number"); }
void TextReader::read(std::int32_t& value) { readNumber(value, "a whole number of 32 bits"); }

void TextReader::read(std::uint32_t& value) {
  skipSpace();
  const bool isHex = end_ - at_ > 2 && at_[0] == '0' && (at_[1] == 'x' || at_[1] == 'X');
  if (!isHex) return readNumber(value, "a whole number of 32 bits");
  const auto [to, error] = std::from_chars(at_ + 2, end_, value, 16);
  if (error != std::errc() || !endsToken(to, end_)) fail("a hexadecimal number of 32 bits");
  at_ = to;
}

void TextReader::read(bool& value) {
  skipSpace();
  for (const auto& [word, meaning] : {std::pair<std::string_view, bool>{"true", true},
                                      {"false", false},
                                      {"TRUE", true},
                                      {"FALSE", false}}) {
    if (!std::string_view(at_, static_cast<std::size_t>(end_ - at_)).starts_with(word)) continue;
    if (!endsToken(at_ + word.size(), end_)) continue;
    at_ += word.size();
    value = meaning;
    return;
  }
  fail("true or false");
}

void TextReader::read(Rotation& value) {
  Rotation rotation;
  numbersAValue_ = 4;
  const double scale = std::exchange(scale_, 1.0);
  for (float& each : rotation.axis) read(each);
  scale_ = scale;
  read(rotation.angle);
  value = rotation;
}

void TextReader::read(Image& value) {
  Image image;
  read(image.width);
  read(image.height);
  read(image.components);
  if (image.width < 0 || image.height < 0 || image.components < 0 || image.components > 4)
    fail("width, height and 0 to 4 components");
  const auto count = static_cast<std::uint64_t>(image.width) * static_cast<std::uint64_t>(image.height);
  // Each pixel takes at least a digit and a separator: a size that the text can't hold is not allocated for.
  if (count > static_cast<std::uint64_t>(end_ - at_)) fail(fmt::format("{} pixels", count));
  image.pixels.resize(count);
  for (auto& pixel : image.pixels) read(pixel);
  value = std::move(image);
}

void TextReader::read(std::string& value) {
  skipSpace();
  if (at_ == end_ || *at_ != '"') fail("a string in double quotes");
  std::string text;
  const char* at = at_ + 1;
  for (; at != end_ && *at != '"'; ++at) {
    if (*at == '\\' && at + 1 != end_ && (at[1] == '"' || at[1] == '\\')) ++at;
    text += *at;
  }
  if (at == end_) fail("a closing double quote");
  at_ = at + 1;
  value = std::move(text);
}

void TextReader::read(NodePtr& value) {
  skipSpace();
  constexpr std::string_view kNull = "NULL";
  if (!std::string_view(at_, static_cast<std::size_t>(end_ - at_)).starts_with(kNull) ||
      !endsToken(at_ + kNull.size(), end_))
    fail("a node element, not text");
  at_ += kNull.size();
  value = nullptr;
}

bool isUnquoted(std::string_view text) {
  return text.find('"') == std::string_view::npos &&
         text.find_first_not_of(" \t\n\r,") != std::string_view::npos;
}

void print(std::string& out, bool value) { out += value ? "true" : "false"; }
void print(std::string& out, std::int32_t value) { fmt::format_to(std::back_inserter(out), "{}", value); }
void print(std::string& out, float value) { fmt::format_to(std::back_inserter(out), "{}", value); }
void print(std::string& out, double value) { fmt::format_to(std::back_inserter(out), "{}", value); }

void print(std::string& out, const Rotation& value) {
  print(out, value.axis);
  out += ' ';
  print(out, value.angle);
}

void print(std::string& out, const Image& value) {
  fmt::format_to(std::back_inserter(out), "{} {} {}", value.width, value.height, value.components);
  for (const auto pixel : value.pixels) fmt::format_to(std::back_inserter(out), " {:#x}", pixel);
}

void print(std::string& out, const std::string& value) {
  out += '"';
  for (const char c : value) {
    if (c == '"' || c == '\\') out += '\\';
    out += c;
  }
  out += '"';
}

void print(std::string& out, const NodePtr& value) { out += value ? "NODE" : "NULL"; }

}  // namespace pleura
