#pragma once

#include <charconv>
#include <string>
#include <string_view>

#include <pleura/fields/errors.h>
#include <pleura/fields/values.h>

namespace pleura {

/// Reads X3D's XML text of field values from left to right; commas count as white space. Every reader throws
/// FieldParseError where the text is not what it expects; NaN and infinities are refused.
class TextReader {
 public:
  /// Floating-point numbers are multiplied by `scale` as they are read, of rotations only the angle: how a
  /// file's own units become SI.
  explicit TextReader(std::string_view text, double scale = 1)
      : begin_(text.data()), at_(begin_), end_(begin_ + text.size()), scale_(scale) {}

  /// White space and commas skipped: is anything left?
  bool atEnd() {
    skipSpace();
    return at_ == end_;
  }
  std::size_t offset() const { return static_cast<std::size_t>(at_ - begin_); }
  [[noreturn]] void fail(const std::string& expected) const { throw FieldParseError(expected, offset()); }
  /// Throws FieldParseError where something is left after a single value.
  void expectEnd();

  void read(bool& value);
  void read(std::int32_t& value);
  void read(std::uint32_t& value);
  void read(float& value);
  void read(double& value);
  void read(Rotation& value);
  void read(Image& value);
  /// Nodes come from elements, not from text: only NULL can be read.
  void read(NodePtr& value);
  /// One of a list: in double quotes, with \" and \\ as escapes.
  void read(std::string& value);

  template <class Scalar, int Rows, int Columns>
  void read(Eigen::Matrix<Scalar, Rows, Columns>& value) {
    numbersAValue_ = static_cast<std::size_t>(value.size());
    for (int i = 0; i < value.size(); ++i) read(value(i / Columns, i % Columns));
  }

 private:
  void skipSpace() {
    while (at_ != end_ && (*at_ == ' ' || *at_ == '\n' || *at_ == '\t' || *at_ == '\r' || *at_ == ',')) ++at_;
  }
  template <class Number>
  void readNumber(Number& value, const char* expected);
  bool readTiny(float& value) const;
  [[noreturn]] void failShort() const;

  const char* begin_;
  const char* at_;
  const char* end_;
  double scale_;
  std::size_t numbersAValue_ = 1;
  std::size_t numbers_ = 0;  // read so far
};

/// A text that X3D means for a list of strings and that has none in double quotes: it is read as one string.
bool isUnquoted(std::string_view text);

/// Appends the text of a value, the shortest that reads back the same.
void print(std::string& out, bool value);
void print(std::string& out, std::int32_t value);
void print(std::string& out, float value);
void print(std::string& out, double value);
void print(std::string& out, const Rotation& value);
void print(std::string& out, const Image& value);
void print(std::string& out, const std::string& value);  // in double quotes
void print(std::string& out, const NodePtr& value);      // NULL, or NODE: its text is its element

template <class Scalar, int Rows, int Columns>
void print(std::string& out, const Eigen::Matrix<Scalar, Rows, Columns>& value) {
  for (int i = 0; i < value.size(); ++i) {
    if (i > 0) out += ' ';
    print(out, value(i / Columns, i % Columns));
  }
}

}  // namespace pleura
