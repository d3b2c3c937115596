#pragma once

#include <pleura/fields/typed_field.h>
#include <pleura/nodes/core/node_type.h>
#include <pleura/nodes/standard/interpolation/x3d_interpolator_node.h>

namespace pleura {

/// An interpolator of one value, or of equally many values, at each key. `Mix::mix(a, b, share)` gives what
/// lies between two key values. The value is computed when it is read.
template <class KeyValues, class Value, class Mix>
class KeyFrameInterpolator : public X3DInterpolatorNode {
 public:
  KeyValues keyValue;

  class ValueChanged : public TypedField<Value, Types<SFFloat>> {
    void update() override {
      auto& node = *static_cast<KeyFrameInterpolator*>(this->getOwner());
      node.interpolate(static_cast<SFFloat*>(this->routes_in[0])->getValue(node.id), this->value);
    }
  };
  ValueChanged value_changed;

  static void declare(NodeType& type, Unit unit, double least, double most) {
    using enum Access;
    X3DInterpolatorNode::declare(type);
    type.field<&KeyFrameInterpolator::keyValue>("keyValue", inputOutput, {})
        .measuredIn(unit)
        .within(least, most)
        .means("the values at the keys, in order");
    type.field<&KeyFrameInterpolator::value_changed>("value_changed", outputOnly, Value().getValue())
        .measuredIn(unit)
        .within(least, most)
        .means("the value at the fraction");
  }
  static void declare(NodeType& type, Unit unit = Unit::none) {
    constexpr double kUnbounded = std::numeric_limits<double>::infinity();
    declare(type, unit, -kUnbounded, kUnbounded);
  }

 protected:
  void onInitialize() override { set_fraction.routeNoEvent(value_changed, id); }

 private:
  static constexpr bool kIsList = isMulti(Value::kFieldType);

  void interpolate(float fraction, typename Value::value_type& value) {
    const auto& frames = keyValue.getValue();
    const std::size_t keys = key.size();
    const std::size_t width = kIsList ? frames.size() / std::max<std::size_t>(keys, 1) : 1;
    const auto at =
        locate(fraction, keyValue, width > 0 ? frames.size() / width : 0, frames.size() == width * keys);
    if (!at) return;
    const auto mixed = [&](std::size_t i) {
      const auto& a = frames[at->from * width + i];
      return at->share > 0 ? Mix::mix(a, frames[(at->from + 1) * width + i], at->share) : a;
    };
    if constexpr (kIsList) {
      value.resize(width);
      for (std::size_t i = 0; i < width; ++i) value[i] = mixed(i);
    } else {
      value = mixed(0);
    }
  }
};

/// A straight line from a to b.
struct LinearMix {
  template <class T>
  static T mix(const T& a, const T& b, float share) {
    return a + share * (b - a);
  }
};

}  // namespace pleura
