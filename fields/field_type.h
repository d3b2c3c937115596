#pragma once

#include <cstdint>
#include <string_view>

namespace pleura {

/// Every field type of X3D 4.0 (ISO/IEC 19775-1, clause 5), MF types right after their SF type.
// The formatter settles on no layout for these.
// clang-format off
#define PLEURA_FIELD_TYPES(X) \
  X(Bool) X(Color) X(ColorRGBA) \
  X(Double) X(Float) X(Image) X(Int32) \
  X(Matrix3d) X(Matrix3f) X(Matrix4d) X(Matrix4f) \
  X(Node) X(Rotation) X(String) X(Time) \
  X(Vec2d) X(Vec2f) X(Vec3d) X(Vec3f) X(Vec4d) X(Vec4f)
// clang-format on

enum class FieldType : std::uint8_t {
#define PLEURA_FIELD_TYPE(T) SF##T, MF##T,
  PLEURA_FIELD_TYPES(PLEURA_FIELD_TYPE)
#undef PLEURA_FIELD_TYPE
};

/// "SFVec3f" and so on.
std::string_view name(FieldType type);

constexpr bool isMulti(FieldType type) { return (static_cast<int>(type) & 1) != 0; }
constexpr FieldType singleOf(FieldType type) { return static_cast<FieldType>(static_cast<int>(type) & ~1); }

}  // namespace pleura
