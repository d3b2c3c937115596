#pragma once

#include <filesystem>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <pleura/x3d/encoding/diagnostics.h>

namespace pleura {

/// A file can't be read. The message names it and says why.
struct FileError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// The whole text of a scene file, unpacked if it is gzip, and where in it things stand.
class SourceText {
 public:
  /// Throws FileError: missing, a directory, not readable, or larger than 2 GB unpacked.
  static SourceText fromFile(const std::filesystem::path& file);
  SourceText(std::string name, std::string text) : name_(std::move(name)), text_(std::move(text)) {}

  const std::string& name() const { return name_; }
  const std::string& text() const { return text_; }

  /// Line and column of a byte, counted from 1.
  std::pair<int, int> lineAndColumn(std::size_t offset) const;
  Place placeAt(std::size_t offset) const;
  /// The start of the tag that ends at or before `end`.
  std::size_t tagBefore(std::size_t end) const;
  /// Where the value of an attribute starts in the tag that starts at `tag`; the tag's own start if it has
  /// none.
  std::size_t attributeValue(std::size_t tag, std::string_view attribute) const;

 private:
  std::string name_;
  std::string text_;
  mutable std::vector<std::size_t> lineStarts_;  // found when first asked for
};

}  // namespace pleura
