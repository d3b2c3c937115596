#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace pleura {

class Node;
using NodePtr = std::shared_ptr<Node>;

using Vec2f = Eigen::Vector2f;
using Vec3f = Eigen::Vector3f;
using Vec4f = Eigen::Vector4f;
using Vec2d = Eigen::Vector2d;
using Vec3d = Eigen::Vector3d;
using Vec4d = Eigen::Vector4d;
using Matrix3f = Eigen::Matrix3f;
using Matrix4f = Eigen::Matrix4f;
using Matrix3d = Eigen::Matrix3d;
using Matrix4d = Eigen::Matrix4d;
using RGB = Eigen::Vector3f;   // red, green, blue in [0, 1]
using RGBA = Eigen::Vector4f;  // and alpha
using Time = double;           // [s]

/// A turn by `angle` [rad] about `axis`; an axis of no length means no turn.
struct Rotation {
  Vec3f axis = Vec3f::UnitZ();
  float angle = 0;

  Rotation() = default;
  Rotation(const Vec3f& about, float by) : axis(about), angle(by) {}
  Rotation(float x, float y, float z, float by) : axis(x, y, z), angle(by) {}
  explicit Rotation(const Eigen::Quaternionf& q);

  Eigen::Quaternionf quaternion() const;
  bool operator==(const Rotation& other) const { return axis == other.axis && angle == other.angle; }
};

/// SFImage: `components` bytes of each 32-bit pixel count, rows from the bottom.
struct Image {
  std::int32_t width = 0;
  std::int32_t height = 0;
  std::int32_t components = 0;
  std::vector<std::uint32_t> pixels;

  bool operator==(const Image&) const = default;
};

}  // namespace pleura
