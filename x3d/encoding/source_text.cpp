#include <algorithm>
#include <iterator>
#include <memory>

#include <zlib.h>

#include <pleura/x3d/encoding/source_text.h>

namespace pleura {

namespace {

constexpr std::size_t kLargest = std::size_t{2} << 30;

std::string unpacked(const std::filesystem::path& file, std::size_t packedSize) {
  const std::unique_ptr<gzFile_s, int (*)(gzFile)> in(gzopen(file.c_str(), "rb"), gzclose);
  if (!in) throw FileError(file.string() + ": can't be read");
  std::string text;
  text.reserve(packedSize + 1);
  constexpr std::size_t kBlock = 1 << 20;
  while (true) {
    const std::size_t had = text.size();
    text.resize(std::max(had + kBlock, text.capacity()));
    const int got = gzread(in.get(), text.data() + had, static_cast<unsigned>(text.size() - had));
    if (got < 0) throw FileError(file.string() + ": damaged gzip data");
    text.resize(had + static_cast<std::size_t>(got));
    if (got == 0) return text;
    if (text.size() > kLargest) throw FileError(file.string() + ": larger than 2 GB");
  }
}

}  // namespace

SourceText SourceText::fromFile(const std::filesystem::path& file) {
  std::error_code error;
  const auto status = std::filesystem::status(file, error);
  if (!std::filesystem::exists(status)) throw FileError(file.string() + ": no such file");
  if (std::filesystem::is_directory(status)) throw FileError(file.string() + ": is a directory, not a scene");
  if (!std::filesystem::is_regular_file(status)) throw FileError(file.string() + ": is not a regular file");
  const auto size = std::filesystem::file_size(file, error);
  if (error || size > kLargest) throw FileError(file.string() + ": can't be read or is larger than 2 GB");
  std::string text = unpacked(file, size);
  if (text.empty()) throw FileError(file.string() + ": is empty");
  return {file.string(), std::move(text)};
}

Place SourceText::placeAt(std::size_t offset) const {
  const auto [line, column] = lineAndColumn(offset);
  return {name_, line, column};
}

std::pair<int, int> SourceText::lineAndColumn(std::size_t offset) const {
  offset = std::min(offset, text_.size());
  if (lineStarts_.empty()) {
    lineStarts_.push_back(0);
    for (auto end = text_.find('\n'); end != std::string::npos; end = text_.find('\n', end + 1))
      lineStarts_.push_back(end + 1);
  }
  const auto next = std::upper_bound(lineStarts_.begin(), lineStarts_.end(), offset);
  return {static_cast<int>(next - lineStarts_.begin()), static_cast<int>(offset - *std::prev(next)) + 1};
}

std::size_t SourceText::tagBefore(std::size_t end) const {
  const auto start = text_.rfind('<', std::min(end, text_.size()));
  return start == std::string::npos ? 0 : start;
}

std::size_t SourceText::attributeValue(std::size_t tag, std::string_view attribute) const {
  const auto isSpace = [](char c) { return c == ' ' || c == '\n' || c == '\t' || c == '\r'; };
  std::size_t at = tag;
  while (at < text_.size() && !isSpace(text_[at]) && text_[at] != '>') ++at;
  while (at < text_.size() && text_[at] != '>') {
    while (at < text_.size() && isSpace(text_[at])) ++at;
    const std::size_t equals = text_.find('=', at);
    if (equals == std::string::npos) return tag;
    const std::size_t quote = text_.find_first_of("'\"", equals);
    if (quote == std::string::npos) return tag;
    std::string_view found = std::string_view(text_).substr(at, equals - at);
    while (!found.empty() && isSpace(found.back())) found.remove_suffix(1);
    if (found == attribute) return quote + 1;
    const std::size_t close = text_.find(text_[quote], quote + 1);
    if (close == std::string::npos) return tag;
    at = close + 1;
  }
  return tag;
}

}  // namespace pleura
