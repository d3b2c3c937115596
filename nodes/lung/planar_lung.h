#pragma once

#include <pleura/fields/typed_field.h>
#include <pleura/nodes/core/node_type.h>
#include <pleura/nodes/lung/planar/planar_lung_system.h>
#include <pleura/nodes/standard/core/x3d_child_node.h>

namespace pleura {

class PlanarChest;

/// A lung of a PlanarChest, with its side of the chest: flat arrays to be drawn, and what is measured.
class PlanarLung : public Node {
 public:
  SFBool isRight;
  SFFloat youngsModulus;
  SFFloat poissonRatio;
  SFFloat density;
  SFFloat relaxationTime;
  SFInt32 rings;
  SFBool pneumothorax;

  /// An output that the chest fills.
  template <class FieldClass, void (PlanarLung::*kFill)(typename FieldClass::value_type&)>
  class Output : public TypedField<FieldClass, AnyNumber<SFTime>> {
    void update() override { (static_cast<PlanarLung*>(this->getOwner())->*kFill)(this->value); }
  };
  void fillLungIndex(std::vector<int>& index);
  void fillLungPoint(std::vector<Vec3f>& points);
  void fillPleuraIndex(std::vector<int>& index);
  void fillPleuraPoint(std::vector<Vec3f>& points);
  void fillWallIndex(std::vector<int>& index);
  void fillWallPoint(std::vector<Vec3f>& points);
  void fillPressure(float& pressure);
  void fillVolume(float& volume);
  Output<MFInt32, &PlanarLung::fillLungIndex> lungIndex;
  Output<MFVec3f, &PlanarLung::fillLungPoint> lungPoint;
  Output<MFInt32, &PlanarLung::fillPleuraIndex> pleuraIndex;
  Output<MFVec3f, &PlanarLung::fillPleuraPoint> pleuraPoint;
  Output<MFInt32, &PlanarLung::fillWallIndex> wallIndex;
  Output<MFVec3f, &PlanarLung::fillWallPoint> wallPoint;
  Output<SFFloat, &PlanarLung::fillPressure> intrapleuralPressure;
  Output<SFFloat, &PlanarLung::fillVolume> lungVolume;

  /// What the chest is told of it. Called by the chest, once it lives in it as lung number `number`.
  planar::SideParameters parameters();
  void join(PlanarChest& chest, std::size_t number);

  static void declare(NodeType& type);

 private:
  /// The chest at the scene's time; null while it belongs to none.
  PlanarLungSystem* now();

  PlanarChest* chest_ = nullptr;
  std::size_t number_ = 0;
  std::vector<Eigen::Vector2d> placed_;
};

}  // namespace pleura
