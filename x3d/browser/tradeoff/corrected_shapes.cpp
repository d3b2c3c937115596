#include <pleura/x3d/browser/tradeoff/corrected_shapes.h>

namespace pleura {

std::vector<std::vector<Vec3f>> correctedShapes(std::vector<std::vector<Vec3f>> shapes,
                                                const std::vector<std::vector<Vec3f>>& cheapFine,
                                                const std::vector<std::vector<Vec3f>>& cheap) {
  for (std::size_t k = 0; k < shapes.size(); ++k)
    for (std::size_t i = 0; i < shapes[k].size(); ++i) shapes[k][i] += cheapFine[k][i] - cheap[k][i];
  return shapes;
}

}  // namespace pleura
