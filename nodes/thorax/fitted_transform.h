#pragma once

#include <vector>

#include <pleura/fields/joined_field.h>
#include <pleura/nodes/standard/grouping/transform.h>

namespace pleura {

/// A rigid body that follows points by least squares: the sternum follows the sternal ends of the ribs.
class FittedTransform : public Transform {
 public:
  MFVec3f from;
  JoinedField<MFVec3f> to;

  static void declare(NodeType& type);

 protected:
  void onInitialize() override;

 private:
  class Fit : public TypedField<SFMatrix4d, Types<MFVec3f, MFVec3f>> {
    void update() override;
    std::vector<Vec3d> from_, to_;
  };
  class FittedRotation : public TypedField<SFRotation, Types<SFMatrix4d>> {
    void update() override;
  };
  class FittedTranslation : public TypedField<SFVec3f, Types<SFMatrix4d>> {
    void update() override;
  };
  Fit fit_;
  FittedRotation rotation_;
  FittedTranslation translation_;
};

}  // namespace pleura
