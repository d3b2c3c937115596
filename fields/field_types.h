#pragma once

#include <pleura/fields/mfield.h>
#include <pleura/fields/sfield.h>

namespace pleura {

/// Every type of value: its name after SF and MF, its C++ type.
#define PLEURA_VALUE_TYPES(X) \
  X(Bool, bool)               \
  X(Color, RGB)               \
  X(ColorRGBA, RGBA)          \
  X(Double, double)           \
  X(Float, float)             \
  X(Image, Image)             \
  X(Int32, std::int32_t)      \
  X(Matrix3d, Matrix3d)       \
  X(Matrix3f, Matrix3f)       \
  X(Matrix4d, Matrix4d)       \
  X(Matrix4f, Matrix4f)       \
  X(Rotation, Rotation)       \
  X(String, std::string)      \
  X(Time, Time)               \
  X(Vec2d, Vec2d)             \
  X(Vec2f, Vec2f)             \
  X(Vec3d, Vec3d)             \
  X(Vec3f, Vec3f)             \
  X(Vec4d, Vec4d)             \
  X(Vec4f, Vec4f)

// SFBool and MFBool and so on, each compiled once, in field_types.cpp.
#define PLEURA_VALUE_FIELDS(name, type)                    \
  using SF##name = SField<type, FieldType::SF##name>;      \
  using MF##name = MField<type, FieldType::MF##name>;      \
  extern template class SField<type, FieldType::SF##name>; \
  extern template class MField<type, FieldType::MF##name>;
PLEURA_VALUE_TYPES(PLEURA_VALUE_FIELDS)
#undef PLEURA_VALUE_FIELDS

/// A node, or none. What kinds it admits is narrowed by TypedSFNode.
class SFNode : public SField<NodePtr, FieldType::SFNode> {
 public:
  virtual bool admits(const Node&) const { return true; }
};

/// Nodes in order; what kinds it admits is narrowed by TypedMFNode.
class MFNode : public MField<NodePtr, FieldType::MFNode> {
 public:
  virtual bool admits(const Node&) const { return true; }
};

}  // namespace pleura
