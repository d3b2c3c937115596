#include <fstream>
#include <stdexcept>

#include <pleura/nodes/deformable/mesh/measures.h>
#include <pleura/x3d/browser/tradeoff/shape_file.h>

namespace pleura {

void writeShapes(const std::filesystem::path& file, const std::vector<std::vector<Vec3f>>& shapes) {
  std::ofstream out(file, std::ios::binary);
  for (const auto& shape : shapes)
    out.write(reinterpret_cast<const char*>(shape.data()),
              static_cast<std::streamsize>(shape.size() * sizeof(Vec3f)));
  if (!out.flush()) throw std::runtime_error(file.string() + ": can't be written");
}

std::optional<std::vector<std::vector<Vec3f>>> readShapes(const std::filesystem::path& file,
                                                          std::size_t moments, std::size_t points) {
  std::error_code missing;
  if (std::filesystem::file_size(file, missing) != moments * points * sizeof(Vec3f) || missing)
    return std::nullopt;
  std::ifstream in(file, std::ios::binary);
  std::vector<std::vector<Vec3f>> shapes(moments, std::vector<Vec3f>(points));
  for (auto& shape : shapes) {
    in.read(reinterpret_cast<char*>(shape.data()), static_cast<std::streamsize>(points * sizeof(Vec3f)));
    if (!in) return std::nullopt;
    for (const Vec3f& point : shape)
      if (!isFinite(point)) return std::nullopt;
  }
  return shapes;
}

}  // namespace pleura
