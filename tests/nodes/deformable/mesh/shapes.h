#pragma once

#include <cmath>
#include <numbers>
#include <random>

#include <pleura/nodes/deformable/mesh/triangle_mesh.h>

namespace pleura::shapes {

/// The cube [0, 1]^3, 12 triangles facing outwards.
inline TriangleMesh cube() {
  TriangleMesh mesh;
  for (int i = 0; i < 8; ++i)
    mesh.points.emplace_back(static_cast<float>(i & 1), static_cast<float>(i >> 1 & 1),
                             static_cast<float>(i >> 2));
  mesh.triangles = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                    {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
  return mesh;
}

/// Grid of around x along quads closed in both directions; place(u, v) with u, v in [0, 1).
template <class Place>
TriangleMesh closedGrid(int around, int along, Place place) {
  TriangleMesh mesh;
  for (int j = 0; j < along; ++j)
    for (int i = 0; i < around; ++i)
      mesh.points.push_back(
          place(i / static_cast<double>(around), j / static_cast<double>(along)).template cast<float>());
  const auto at = [=](int i, int j) { return (j % along) * around + i % around; };
  for (int j = 0; j < along; ++j) {
    for (int i = 0; i < around; ++i) {
      mesh.triangles.emplace_back(at(i, j), at(i + 1, j), at(i + 1, j + 1));
      mesh.triangles.emplace_back(at(i, j), at(i + 1, j + 1), at(i, j + 1));
    }
  }
  return mesh;
}

/// A torus about z: ring radius 1, tube radius `tube`.
inline TriangleMesh torus(int around, int along, double tube = 0.4) {
  return closedGrid(around, along, [tube](double u, double v) {
    const double a = 2 * std::numbers::pi * u, b = 2 * std::numbers::pi * v;
    const double r = 1 + tube * std::cos(b);
    return Eigen::Vector3d(r * std::cos(a), r * std::sin(a), tube * std::sin(b));
  });
}

/// A unit sphere of n meridians and n / 2 - 1 circles of latitude, closed by a point at either pole.
inline TriangleMesh sphere(int n) {
  TriangleMesh mesh;
  const int circles = n / 2 - 1;
  for (int j = 1; j <= circles; ++j) {
    for (int i = 0; i < n; ++i) {
      const double a = 2 * std::numbers::pi * i / n, b = std::numbers::pi * j / (circles + 1);
      mesh.points.push_back(
          Eigen::Vector3d(std::cos(a) * std::sin(b), std::sin(a) * std::sin(b), std::cos(b)).cast<float>());
    }
  }
  const int north = static_cast<int>(mesh.points.size()), south = north + 1;
  mesh.points.emplace_back(0, 0, 1);
  mesh.points.emplace_back(0, 0, -1);
  for (int i = 0; i < n; ++i) {
    const int next = (i + 1) % n, last = (circles - 1) * n;
    mesh.triangles.emplace_back(north, i, next);
    mesh.triangles.emplace_back(south, last + next, last + i);
    for (int j = 0; j + 1 < circles; ++j) {
      mesh.triangles.emplace_back(j * n + i, (j + 1) * n + i, (j + 1) * n + next);
      mesh.triangles.emplace_back(j * n + i, (j + 1) * n + next, j * n + next);
    }
  }
  return mesh;
}

inline TriangleMesh flipped(TriangleMesh mesh) {
  for (Eigen::Vector3i& triangle : mesh.triangles) std::swap(triangle[1], triangle[2]);
  return mesh;
}

/// Uniform in [-reach, reach]^3.
inline Eigen::Vector3d randomPoint(std::mt19937& random, double reach = 1) {
  std::uniform_real_distribution<double> coordinate(-reach, reach);
  const double x = coordinate(random), y = coordinate(random), z = coordinate(random);
  return {x, y, z};
}

/// Unconnected triangles with corners in [-1, 1]^3.
inline TriangleMesh soup(int triangles, std::mt19937& random) {
  TriangleMesh mesh;
  for (int t = 0; t < triangles; ++t) {
    for (int k = 0; k < 3; ++k) mesh.points.push_back(randomPoint(random).cast<float>());
    mesh.triangles.emplace_back(3 * t, 3 * t + 1, 3 * t + 2);
  }
  return mesh;
}

}  // namespace pleura::shapes
