#include <cstdint>
#include <cstring>
#include <stdexcept>
#include <string_view>

#include <pleura/x3d/import/raw_part.h>

namespace pleura {

namespace {

template <class T>
void append(std::string& bytes, const T* items, std::size_t count) {
  const std::uint64_t size = count;
  bytes.append(reinterpret_cast<const char*>(&size), sizeof size);
  bytes.append(reinterpret_cast<const char*>(items), count * sizeof(T));
}

class Unpacker {
 public:
  explicit Unpacker(std::string_view bytes) : bytes_(bytes) {}

  bool isAtEnd() const { return bytes_.empty(); }

  template <class Items>
  void read(Items& items) {
    std::uint64_t count = 0;
    copy(&count, sizeof count);
    if (count > bytes_.size() / sizeof(items[0])) throw std::invalid_argument("bytes: end too early");
    items.resize(count);
    copy(items.data(), count * sizeof(items[0]));
  }

  void copy(void* target, std::size_t size) {
    if (size > bytes_.size()) throw std::invalid_argument("bytes: end too early");
    if (size > 0) std::memcpy(target, bytes_.data(), size);
    bytes_.remove_prefix(size);
  }

 private:
  std::string_view bytes_;
};

}  // namespace

std::string pack(std::span<const RawPart> parts) {
  std::string bytes;
  for (const RawPart& part : parts) {
    append(bytes, part.name.data(), part.name.size());
    bytes.append(reinterpret_cast<const char*>(part.colour.data()), sizeof(float) * 4);
    append(bytes, part.points.data(), part.points.size());
    append(bytes, part.triangles.data(), part.triangles.size());
  }
  return bytes;
}

std::vector<RawPart> unpack(std::string_view bytes) {
  std::vector<RawPart> parts;
  for (Unpacker unpacker(bytes); !unpacker.isAtEnd();) {
    RawPart& part = parts.emplace_back();
    unpacker.read(part.name);
    unpacker.copy(part.colour.data(), sizeof(float) * 4);
    unpacker.read(part.points);
    unpacker.read(part.triangles);
  }
  return parts;
}

}  // namespace pleura
