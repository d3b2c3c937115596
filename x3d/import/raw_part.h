#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <Eigen/Core>

namespace pleura {

/// A part as a reader left it: nothing about it can be relied on.
struct RawPart {
  std::string name;
  Eigen::Vector4f colour;               // red, green, blue, opacity
  std::vector<Eigen::Vector3d> points;  // where the file's nodes put them, in its own axes and unit
  std::vector<Eigen::Vector3i> triangles;
};

/// To bytes and back, for a pipe between two processes of one machine. unpack throws std::invalid_argument on
/// bytes that pack didn't make and never takes more memory than they do.
std::string pack(std::span<const RawPart> parts);
std::vector<RawPart> unpack(std::string_view bytes);

}  // namespace pleura
