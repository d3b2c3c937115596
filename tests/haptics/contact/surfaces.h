#pragma once

#include <cmath>
#include <functional>
#include <numbers>
#include <random>
#include <vector>

#include <Eigen/Geometry>

#include <pleura/haptics/contact/touch_shape.h>

namespace pleura::haptics::surfaces {

using Eigen::Vector3d;
using Eigen::Vector3f;
using Eigen::Vector3i;

struct Surface {
  std::vector<Vector3f> points;
  std::vector<Vector3i> triangles;
};

/// 2 slices (stacks - 1) triangles that face outwards; radius(direction) [m].
inline Surface sphere(int slices, int stacks, const std::function<double(const Vector3d&)>& radius) {
  Surface surface;
  const auto add = [&](double polar, double turn) {
    const Vector3d direction(std::sin(polar) * std::cos(turn), std::sin(polar) * std::sin(turn),
                             std::cos(polar));
    surface.points.push_back((radius(direction) * direction).cast<float>());
  };
  add(0, 0);
  for (int i = 1; i < stacks; ++i)
    for (int j = 0; j < slices; ++j) add(std::numbers::pi * i / stacks, 2 * std::numbers::pi * j / slices);
  add(std::numbers::pi, 0);
  const auto at = [&](int i, int j) { return 1 + (i - 1) * slices + j % slices; };
  const int last = static_cast<int>(surface.points.size()) - 1;
  for (int j = 0; j < slices; ++j) {
    surface.triangles.emplace_back(0, at(1, j), at(1, j + 1));
    for (int i = 1; i < stacks - 1; ++i) {
      surface.triangles.emplace_back(at(i, j), at(i + 1, j), at(i + 1, j + 1));
      surface.triangles.emplace_back(at(i, j), at(i + 1, j + 1), at(i, j + 1));
    }
    surface.triangles.emplace_back(at(stacks - 1, j), last, at(stacks - 1, j + 1));
  }
  return surface;
}

inline Surface sphere(int slices, int stacks, double radius) {
  return sphere(slices, stacks, [radius](const Vector3d&) { return radius; });
}

/// [m] of a sphere of 5 cm with bumps of 1 mm.
inline double bumpyRadius(const Vector3d& d) {
  return 0.05 + 0.001 * std::sin(9 * d.x()) * std::cos(11 * d.y()) * std::sin(7 * d.z() + 1);
}

/// A box about the origin, facing outwards; each side of n x n squares of two triangles.
inline Surface box(const Vector3d& halfSize, int n = 1) {
  Surface surface;
  for (int axis = 0; axis < 3; ++axis)
    for (const int side : {-1, 1}) {
      const int u = (axis + 1) % 3, v = (axis + 2) % 3, first = static_cast<int>(surface.points.size());
      for (int i = 0; i <= n; ++i)
        for (int j = 0; j <= n; ++j) {
          Vector3d p;
          p[axis] = side;
          p[u] = 2.0 * i / n - 1;
          p[v] = 2.0 * j / n - 1;
          surface.points.push_back(p.cwiseProduct(halfSize).cast<float>());
        }
      for (int i = 0; i < n; ++i)
        for (int j = 0; j < n; ++j) {
          const int a = first + i * (n + 1) + j, b = a + n + 1;
          Vector3i s(a, b, b + 1), t(a, b + 1, a + 1);
          if (side < 0) {
            std::swap(s[1], s[2]);
            std::swap(t[1], t[2]);
          }
          surface.triangles.push_back(s);
          surface.triangles.push_back(t);
        }
    }
  return surface;
}

/// A sheet z = height(x, y) over the square |x|, |y| <= half, facing +Z.
inline Surface sheet(double half, int n, const std::function<double(double, double)>& height) {
  Surface surface;
  for (int i = 0; i <= n; ++i)
    for (int j = 0; j <= n; ++j) {
      const double x = half * (2.0 * i / n - 1), y = half * (2.0 * j / n - 1);
      surface.points.push_back(Vector3d(x, y, height(x, y)).cast<float>());
    }
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) {
      const int a = i * (n + 1) + j, b = a + n + 1;
      surface.triangles.emplace_back(a, b, b + 1);
      surface.triangles.emplace_back(a, b + 1, a + 1);
    }
  return surface;
}

/// What the proxy is given: a surface that stands, or goes from one frame to the next.
struct Touchable {
  explicit Touchable(const Surface& surface, std::uint32_t id = 1) : mesh(surface.points, surface.triangles) {
    from.fit(mesh, surface.points);
    shape.id = id;
    shape.mesh = &mesh;
    shape.from = shape.to = &from;
    shape.surface.stiffness = 500;
  }
  Touchable(const Touchable&) = delete;
  Touchable& operator=(const Touchable&) = delete;

  /// The last frame becomes the first; the new one is gone to as s goes from 0 to 1.
  void goTo(const std::vector<Vector3f>& points) {
    if (shape.to == &to) std::swap(from, to);
    to.fit(mesh, points);
    shape.from = &from;
    shape.to = &to;
    shape.s = 0;
  }

  TouchMesh mesh;
  TouchMeshFrame from, to;
  TouchShape shape;
};

/// [m] from the nearest point of the shape.
inline double distanceTo(const TouchShape& shape, const Vector3d& p) {
  double least = 1e30;
  for (int t = 0; t < static_cast<int>(shape.mesh->triangles().size()); ++t)
    least = std::min(least, (p - nearestOnTriangle(cornersOf(shape, t), p).point).norm());
  return least;
}

inline Vector3d randomPoint(std::mt19937& random, double half) {
  std::uniform_real_distribution<double> coordinate(-half, half);
  const double x = coordinate(random), y = coordinate(random), z = coordinate(random);
  return {x, y, z};
}

}  // namespace pleura::haptics::surfaces
