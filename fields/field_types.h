#pragma once

#include <pleura/fields/mfield.h>
#include <pleura/fields/sfield.h>

namespace pleura {

using SFBool = SField<bool, FieldType::SFBool>;
using SFColor = SField<RGB, FieldType::SFColor>;
using SFColorRGBA = SField<RGBA, FieldType::SFColorRGBA>;
using SFDouble = SField<double, FieldType::SFDouble>;
using SFFloat = SField<float, FieldType::SFFloat>;
using SFImage = SField<Image, FieldType::SFImage>;
using SFInt32 = SField<std::int32_t, FieldType::SFInt32>;
using SFMatrix3d = SField<Matrix3d, FieldType::SFMatrix3d>;
using SFMatrix3f = SField<Matrix3f, FieldType::SFMatrix3f>;
using SFMatrix4d = SField<Matrix4d, FieldType::SFMatrix4d>;
using SFMatrix4f = SField<Matrix4f, FieldType::SFMatrix4f>;
using SFRotation = SField<Rotation, FieldType::SFRotation>;
using SFString = SField<std::string, FieldType::SFString>;
using SFTime = SField<Time, FieldType::SFTime>;
using SFVec2d = SField<Vec2d, FieldType::SFVec2d>;
using SFVec2f = SField<Vec2f, FieldType::SFVec2f>;
using SFVec3d = SField<Vec3d, FieldType::SFVec3d>;
using SFVec3f = SField<Vec3f, FieldType::SFVec3f>;
using SFVec4d = SField<Vec4d, FieldType::SFVec4d>;
using SFVec4f = SField<Vec4f, FieldType::SFVec4f>;

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

using MFBool = MField<bool, FieldType::MFBool>;
using MFColor = MField<RGB, FieldType::MFColor>;
using MFColorRGBA = MField<RGBA, FieldType::MFColorRGBA>;
using MFDouble = MField<double, FieldType::MFDouble>;
using MFFloat = MField<float, FieldType::MFFloat>;
using MFImage = MField<Image, FieldType::MFImage>;
using MFInt32 = MField<std::int32_t, FieldType::MFInt32>;
using MFMatrix3d = MField<Matrix3d, FieldType::MFMatrix3d>;
using MFMatrix3f = MField<Matrix3f, FieldType::MFMatrix3f>;
using MFMatrix4d = MField<Matrix4d, FieldType::MFMatrix4d>;
using MFMatrix4f = MField<Matrix4f, FieldType::MFMatrix4f>;
using MFRotation = MField<Rotation, FieldType::MFRotation>;
using MFString = MField<std::string, FieldType::MFString>;
using MFTime = MField<Time, FieldType::MFTime>;
using MFVec2d = MField<Vec2d, FieldType::MFVec2d>;
using MFVec2f = MField<Vec2f, FieldType::MFVec2f>;
using MFVec3d = MField<Vec3d, FieldType::MFVec3d>;
using MFVec3f = MField<Vec3f, FieldType::MFVec3f>;
using MFVec4d = MField<Vec4d, FieldType::MFVec4d>;
using MFVec4f = MField<Vec4f, FieldType::MFVec4f>;

}  // namespace pleura
