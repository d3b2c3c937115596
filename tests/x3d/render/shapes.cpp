#include "shapes.h"

#include <cmath>
#include <numbers>

namespace pleura::render::test {
namespace {

constexpr float pi = std::numbers::pi_v<float>;

/// Triangles of a grid of (columns + 1) x (rows + 1) vertices, row after row.
void weave(Shape& shape, std::uint32_t columns, std::uint32_t rows) {
  for (std::uint32_t r = 0; r < rows; ++r)
    for (std::uint32_t c = 0; c < columns; ++c) {
      const std::uint32_t a = r * (columns + 1) + c, b = a + columns + 1;
      for (const std::uint32_t i : {a, b, b + 1, a, b + 1, a + 1}) shape.indices.push_back(i);
    }
}

}  // namespace

Shape& Shape::refresh() {
  geometry.positions = positions;
  geometry.normals = normals;
  geometry.colors = colors;
  geometry.indices = indices;
  return *this;
}

Shape sphere(float radius, int rings) {
  Shape shape;
  for (int r = 0; r <= rings; ++r)
    for (int c = 0; c <= rings; ++c) {
      const float polar = pi * static_cast<float>(r) / static_cast<float>(rings);
      const float azimuth = 2 * pi * static_cast<float>(c) / static_cast<float>(rings);
      const Eigen::Vector3f n(std::sin(polar) * std::sin(azimuth), std::cos(polar),
                              std::sin(polar) * std::cos(azimuth));
      shape.normals.push_back(n);
      shape.positions.push_back(radius * n);
    }
  weave(shape, static_cast<std::uint32_t>(rings), static_cast<std::uint32_t>(rings));
  shape.refresh();
  return shape;
}

Shape rectangle(float width, float height) {
  Shape shape;
  for (const float y : {height / 2, -height / 2})
    for (const float x : {-width / 2, width / 2}) shape.positions.emplace_back(x, y, 0);
  shape.normals.assign(4, Eigen::Vector3f::UnitZ());
  weave(shape, 1, 1);
  shape.refresh();
  return shape;
}

Shape rod(float radius, float height) {
  Shape shape;
  constexpr int sides = 12;
  for (const float y : {height / 2, -height / 2})
    for (int c = 0; c <= sides; ++c) {
      const float azimuth = 2 * pi * static_cast<float>(c) / sides;
      const Eigen::Vector3f n(std::sin(azimuth), 0, std::cos(azimuth));
      shape.normals.push_back(n);
      shape.positions.push_back(radius * n + Eigen::Vector3f(0, y, 0));
    }
  weave(shape, sides, 1);
  shape.refresh();
  return shape;
}

Shape trough(float radius, float length) {
  Shape shape;
  constexpr int steps = 24;
  for (const float z : {length / 2, -length / 2})
    for (int c = 0; c <= steps; ++c) {
      const float angle = pi * static_cast<float>(c) / steps;
      const Eigen::Vector3f outwards(-std::cos(angle), -std::sin(angle), 0);
      shape.normals.push_back(outwards);
      shape.positions.push_back(radius * outwards + Eigen::Vector3f(0, 0, z));
    }
  weave(shape, steps, 1);
  shape.geometry.solid = false;
  shape.refresh();
  return shape;
}

void lookFrom(DrawList& list, const Eigen::Vector3f& eye) {
  const Eigen::Vector3f z = eye.normalized(), x = Eigen::Vector3f::UnitY().cross(z).normalized(),
                        y = z.cross(x);
  list.camera.view = Eigen::Matrix4f::Identity();
  list.camera.view.topLeftCorner<3, 3>() << x.transpose(), y.transpose(), z.transpose();
  list.camera.view.topRightCorner<3, 1>() = -list.camera.view.topLeftCorner<3, 3>() * eye;
}

Eigen::Matrix4f translation(float x, float y, float z) {
  return Eigen::Affine3f(Eigen::Translation3f(x, y, z)).matrix();
}

}  // namespace pleura::render::test
