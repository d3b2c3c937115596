#pragma once

#include <optional>
#include <vector>

#include <pleura/fields/auto_update.h>
#include <pleura/fields/typed_field.h>
#include <pleura/nodes/core/typed_node_field.h>
#include <pleura/nodes/lung/mechanics/pleural_space.h>
#include <pleura/nodes/lung/shape/freed_lung.h>
#include <pleura/nodes/standard/core/x3d_child_node.h>
#include <pleura/nodes/thorax/lung_contacts.h>

namespace pleura {

/// The thin space between a lung and the cage. The cage says how large the cavity is; pressures, flow and the
/// lung's volume come out (mechanics/pleural_space.h). While there is only the liquid film, the lung keeps to
/// the wall; gas sets it free, and it takes the shape that its own elasticity and the wall give it
/// (shape/freed_lung.h). Goes on with the scene's time when somebody looks; over a time when nobody did, the
/// cavity is taken to have changed evenly.
class PleuralSpace : public X3DChildNode {
 public:
  TypedSFNode<LungContacts> contacts;
  SFFloat compliance;
  SFFloat restingRecoil;
  SFString recoil;
  SFFloat airwayResistance;
  SFFloat ambientPressure;
  SFFloat poissonRatio;
  SFInt32 elements;

  SFString pneumothorax;
  SFFloat leakArea;
  SFString leakSource;
  SFFloat gasVolume;
  SFBool drain;
  SFFloat drainSuction;
  SFFloat drainResistance;
  SFString keyPress;
  SFString woundKeys;
  SFString drainKeys;

  /// A number of the present state.
  template <double LungState::*kNumber>
  class Output : public TypedField<SFFloat, AnyNumber<Any<SFTime, MFVec3f>>> {
    void update() override {
      value = static_cast<float>(static_cast<PleuralSpace*>(getOwner())->now().*kNumber);
    }
  };
  Output<&LungState::intrapleural> intrapleuralPressure;
  Output<&LungState::alveolar> alveolarPressure;
  Output<&LungState::transpulmonary> transpulmonaryPressure;
  Output<&LungState::airFlow> airFlow;
  Output<&LungState::lungVolume> lungVolume;
  Output<&LungState::cavityVolume> cavityVolume;

  class PleuralGas : public TypedField<SFFloat, AnyNumber<Any<SFTime, MFVec3f>>> {
    void update() override;
  };
  PleuralGas pleuralGas;

  class Label : public TypedField<MFString, AnyNumber<Any<SFTime, MFVec3f>>> {
    void update() override;
  };
  Label label;

  class Index : public TypedField<MFInt32, AnyNumber<Any<SFTime, MFVec3f>>> {
    void update() override { static_cast<PleuralSpace*>(getOwner())->evaluateIndex(value); }
  };
  Index index;

  class Point : public TypedField<MFVec3f, AnyNumber<Any<SFTime, MFVec3f>>> {
    void update() override { static_cast<PleuralSpace*>(getOwner())->evaluatePoint(value); }
  };
  Point point;

  /// The state at the scene's time.
  const LungState& now();
  /// The last step up to there, for who wants to know what changes.
  struct Step {
    LungMechanics lung;
    PleuralInputs inputs;
    LungState before;
    double duration = 0;  // [s]; 0: none was made yet
  };
  const Step& lastStep();

  static void declare(NodeType& type);

 protected:
  void onInitialize() override;

 private:
  class HearKey : public AutoUpdate<TypedField<SFBool, Types<SFString>>> {
   public:
    explicit HearKey(PleuralSpace& node) : node_(node) {}

   private:
    void update() override { node_.onKey(); }
    PleuralSpace& node_;
  };
  /// What is changed counts from that moment on, whether anybody looks then or not.
  class HearChange : public AutoUpdate<TypedField<SFBool, AnyNumber<Any<SFString, SFBool, SFFloat>>>> {
   public:
    explicit HearChange(PleuralSpace& node) : node_(node) {}

   private:
    void update() override { node_.now(); }
    PleuralSpace& node_;
  };
  HearKey hearKey_{*this};
  HearChange hearChange_{*this};

  void onKey();
  /// Starts anew with the lung's rest shape, in balance with the cavity; where it can't, that is told.
  void beginAt(Time time, double cavity);
  void begin(double cavity);
  void advanceTo(Time time, double cavity);
  void takeInputs();
  /// Whether the lung has left the wall.
  bool isFree();
  void evaluateIndex(std::vector<int>& out);
  void evaluatePoint(std::vector<Vec3f>& out);

  Step step_;
  LungState state_;
  std::uint64_t restStamp_ = 0;
  Time time_ = 0;
  PleuralInputs inputs_;            // that hold from time_ on
  std::optional<FreedLung> freed_;  // made when gas first comes in
  bool isRefused_ = false;          // the lung can't be set free: it stays on the wall
};

}  // namespace pleura
