#pragma once

#include <map>
#include <utility>

#include <pleura/nodes/deformable/mesh/triangle_mesh.h>

namespace pleura {

/// A sphere of 20 * 4^subdivisions triangles about the origin: an icosahedron whose triangles are quartered.
inline TriangleMesh icosphere(int subdivisions, float radius) {
  const float g = 1.6180339887f;  // golden ratio
  TriangleMesh mesh{{{-1, g, 0},
                     {1, g, 0},
                     {-1, -g, 0},
                     {1, -g, 0},
                     {0, -1, g},
                     {0, 1, g},
                     {0, -1, -g},
                     {0, 1, -g},
                     {g, 0, -1},
                     {g, 0, 1},
                     {-g, 0, -1},
                     {-g, 0, 1}},
                    {{0, 11, 5},  {0, 5, 1},  {0, 1, 7},  {0, 7, 10}, {0, 10, 11}, {1, 5, 9}, {5, 11, 4},
                     {11, 10, 2}, {10, 7, 6}, {7, 1, 8},  {3, 9, 4},  {3, 4, 2},   {3, 2, 6}, {3, 6, 8},
                     {3, 8, 9},   {4, 9, 5},  {2, 4, 11}, {6, 2, 10}, {8, 6, 7},   {9, 8, 1}}};
  for (int level = 0; level < subdivisions; ++level) {
    std::map<std::pair<int, int>, int> middles;
    const auto middle = [&](int a, int b) {
      const auto [entry, isNew] =
          middles.try_emplace(std::minmax(a, b), static_cast<int>(mesh.points.size()));
      if (isNew) mesh.points.push_back((mesh.points[a].normalized() + mesh.points[b].normalized()) / 2);
      return entry->second;
    };
    std::vector<Eigen::Vector3i> quarters;
    for (const Eigen::Vector3i& t : mesh.triangles) {
      const int a = middle(t[0], t[1]), b = middle(t[1], t[2]), c = middle(t[2], t[0]);
      quarters.insert(quarters.end(), {{t[0], a, c}, {t[1], b, a}, {t[2], c, b}, {a, b, c}});
    }
    mesh.triangles = std::move(quarters);
  }
  for (Eigen::Vector3f& point : mesh.points) point = radius * point.normalized();
  return mesh;
}

}  // namespace pleura
