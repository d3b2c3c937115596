#pragma once

#include <vector>

#include <Eigen/Geometry>

#include <pleura/x3d/browser/render/draw_list.h>

namespace pleura::render::test {

/// A Geometry with the arrays it looks at.
struct Shape {
  std::vector<Eigen::Vector3f> positions;
  std::vector<Eigen::Vector3f> normals;
  std::vector<Eigen::Vector4f> colors;
  std::vector<std::uint32_t> indices;
  Geometry geometry;

  /// Points the Geometry at the arrays, as they are now.
  Shape& refresh();
};

/// A sphere about the origin, 2 * rings * rings triangles or so, smooth.
Shape sphere(float radius, int rings);

/// A rectangle about the origin in the plane z = 0, facing +Z.
Shape rectangle(float width, float height);

/// A closed prism of 12 sides along Y about the origin, smooth round its axis.
Shape rod(float radius, float height);

/// A trough open to +Y, half a cylinder along Z, seen from inside and outside.
Shape trough(float radius, float length);

/// The list's camera at `eye`, looking at the origin with +Y up.
void lookFrom(DrawList& list, const Eigen::Vector3f& eye);

Eigen::Matrix4f translation(float x, float y, float z);

}  // namespace pleura::render::test
