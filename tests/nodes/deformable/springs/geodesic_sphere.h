#pragma once

#include <algorithm>
#include <array>
#include <map>
#include <utility>

#include <pleura/tests/nodes/deformable/chainmail/icosphere.h>

namespace pleura {

/// A sphere of 10 n^2 + 2 points about the origin: an icosahedron whose edges are cut into n, pushed
/// outwards.
inline TriangleMesh geodesicSphere(int n, float radius) {
  const TriangleMesh icosahedron = icosphere(0, 1);
  TriangleMesh mesh;
  std::map<std::array<std::pair<int, int>, 3>, int> found;
  for (const Eigen::Vector3i& face : icosahedron.triangles) {
    // the point i steps towards the second corner and j towards the third
    const auto at = [&](int i, int j) {
      const Eigen::Vector3i steps(n - i - j, i, j);
      std::array<std::pair<int, int>, 3> key;
      for (int k = 0; k < 3; ++k) key[k] = steps[k] > 0 ? std::pair(face[k], steps[k]) : std::pair(-1, 0);
      std::sort(key.begin(), key.end());
      const auto [entry, isNew] = found.try_emplace(key, static_cast<int>(mesh.points.size()));
      if (isNew) {
        Eigen::Vector3d sum = Eigen::Vector3d::Zero();
        for (int k = 0; k < 3; ++k) sum += steps[k] * icosahedron.points[face[k]].cast<double>();
        mesh.points.push_back((radius * sum.normalized()).cast<float>());
      }
      return entry->second;
    };
    for (int i = 0; i < n; ++i)
      for (int j = 0; i + j < n; ++j) {
        mesh.triangles.emplace_back(at(i, j), at(i + 1, j), at(i, j + 1));
        if (i + j + 1 < n) mesh.triangles.emplace_back(at(i + 1, j), at(i + 1, j + 1), at(i, j + 1));
      }
  }
  return mesh;
}

}  // namespace pleura
