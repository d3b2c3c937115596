#pragma once

#include <pleura/fields/typed_field.h>
#include <pleura/nodes/standard/grouping/transform.h>

namespace pleura {

/// (1 + sin(2 pi f t)) / 2, f the frequency [1/s] and t the time [s]. Of a TimeSensor's `time` the pauses are
/// taken off: the breath goes on from where it stood.
double sineInflation(SFTime& time, double frequency);

/// A rib: turns about its costovertebral joint (`center`), the pump handle about the left-right axis, then
/// the bucket handle about the dorso-ventral axis, as far as the chest is inflated.
class RotTransform : public Transform {
 public:
  SFVec3f angles;
  SFFloat inflation;

  /// The thesis' way: amplitudes times (1 + sin(2 pi f t)) / 2, to be routed on to `rotation`.
  class Rota : public TypedField<SFRotation, Types<SFTime>> {
    void update() override;
  };
  Rota rota;
  SFFloat frequency;

  MFVec3f points;
  class Followed : public TypedField<MFVec3f, Types<MFVec3f, SFMatrix4f>> {
    void update() override;
  };
  Followed rib_points;

  static void declare(NodeType& type);

 protected:
  void onInitialize() override;

 private:
  class Turn : public TypedField<SFRotation, Types<SFVec3f, SFFloat>> {
    void update() override;
  };
  Turn turn_;
};

}  // namespace pleura
