#pragma once

#include <string>

#include <pleura/fields/auto_update.h>
#include <pleura/fields/typed_field.h>
#include <pleura/nodes/core/node_type.h>
#include <pleura/nodes/standard/core/x3d_child_node.h>
#include <pleura/nodes/thorax/breathing_pattern.h>

namespace pleura {

/// The breath that a thorax breathes: one scalar, `inflation`, that ribs and diaphragm follow. Everything is
/// live: a new rate or a pause takes hold at once and without a jump, a new depth or style with the next
/// breath.
class Respiration : public X3DChildNode {
 public:
  SFFloat rate;
  SFFloat depth;
  SFString style;
  SFBool paused;
  SFString pauseKeys;

  SFString keyPress;

  class Sum : public TypedField<SFFloat, AnyNumber<SFFloat>> {
    void update() override;
  };
  Sum organVolume;
  SFFloat diaphragmTop;

  SFFloat phase;
  SFFloat inflation;
  SFFloat lungVolume;
  SFFloat domeHeight;
  /// Largest less smallest lung volume of the last whole breath, of the present one until there is one: of
  /// the times at which it was read.
  class Swing : public TypedField<SFFloat, Types<SFFloat>> {
    void update() override;
    double breath_ = -1;
    float least_ = 0, most_ = 0, wholeBreath_ = 0;
  };
  Swing tidalVolume;

  static void declare(NodeType& type);

 protected:
  void onInitialize() override;

 private:
  /// Calls one function of the node after every event from any of its inputs.
  template <void (Respiration::*kCall)()>
  class Hear : public AutoUpdate<TypedField<SFBool, AnyNumber<Any<SFTime, SFFloat, SFBool, SFString>>>> {
   public:
    explicit Hear(Respiration& node) : node_(node) {}

   private:
    void update() override { (node_.*kCall)(); }
    Respiration& node_;
  };

  void onTime();
  void onKey();
  void onChange();
  /// Breaths [1] since the start: n = n0 + rate (t - t0) / 60, held while paused.
  double breathsAt(Time t) const;
  /// From now on counts with the present rate and pause.
  void anchor();
  void takeDepthAndStyle();
  void publish(double breaths);

  Time anchorTime_ = 0;       // t0 [s]
  double anchorBreaths_ = 0;  // n0
  float anchorRate_ = 0;      // [1/min]; 0 while paused
  double breaths_ = 0;
  float activeDepth_ = 0;
  BreathingPattern activePattern_ = BreathingPattern::oneToTwo;

  Hear<&Respiration::onTime> hearTime_{*this};
  Hear<&Respiration::onKey> hearKey_{*this};
  Hear<&Respiration::onChange> hearChange_{*this};
};

}  // namespace pleura
