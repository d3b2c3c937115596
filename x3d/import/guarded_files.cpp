#include <algorithm>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <vector>

#include <assimp/IOStream.hpp>

#include <pleura/x3d/import/guarded_files.h>

namespace pleura {

namespace {

class GuardedStream : public Assimp::IOStream {
 public:
  explicit GuardedStream(std::vector<char> content)
      : content_(std::move(content)), budget_(readings * content_.size() + slack) {}

  std::size_t Read(void* target, std::size_t size, std::size_t count) override {
    const std::size_t whole = size == 0 ? 0 : std::min(count, (content_.size() - position_) / size);
    const std::size_t cost = whole * size + 1;
    if (cost > budget_) throw std::runtime_error("ends too early");
    budget_ -= cost;
    if (whole > 0) std::memcpy(target, content_.data() + position_, whole * size);
    position_ += whole * size;
    return whole;
  }

  aiReturn Seek(std::size_t offset, aiOrigin origin) override {
    const std::size_t from = origin == aiOrigin_SET   ? 0
                             : origin == aiOrigin_CUR ? position_
                                                      : content_.size();
    const std::size_t to = origin == aiOrigin_END ? from - offset : from + offset;
    if (to > content_.size()) return AI_FAILURE;
    position_ = to;
    return AI_SUCCESS;
  }

  std::size_t Write(const void*, std::size_t, std::size_t) override { return 0; }
  std::size_t Tell() const override { return position_; }
  std::size_t FileSize() const override { return content_.size(); }
  void Flush() override {}

 private:
  static constexpr std::size_t readings = 8;
  static constexpr std::size_t slack = 1 << 16;

  std::vector<char> content_;
  std::size_t position_ = 0;
  std::size_t budget_;  // bytes, and one for each call
};

}  // namespace

bool GuardedFiles::Exists(const char* file) const {
  return name_.empty() ? DefaultIOSystem::Exists(file) : file == name_;
}

Assimp::IOStream* GuardedFiles::Open(const char* file, const char*) {
  if (!name_.empty()) {
    if (file != name_) return nullptr;
    const auto* begin = reinterpret_cast<const char*>(content_.data());
    return new GuardedStream(std::vector<char>(begin, begin + content_.size()));
  }
  std::error_code error;
  if (!std::filesystem::is_regular_file(file, error)) return nullptr;  // a pipe would be waited for
  std::ifstream stream(file, std::ios::binary);
  if (!stream) return nullptr;
  return new GuardedStream(std::vector<char>(std::istreambuf_iterator<char>(stream), {}));
}

}  // namespace pleura
