#include <pleura/nodes/core/node_type.h>
#include <pleura/nodes/standard/interpolation/ease_in_ease_out.h>

namespace pleura {

void EaseInEaseOut::declare(NodeType& type) {
  Node::declare(type);
  type.named("EaseInEaseOut", "Interpolation", 4)
      .means("a fraction that starts and stops gently between keys");
  using enum Access;
  type.field<&EaseInEaseOut::easeInEaseOut>("easeInEaseOut", inputOutput, {})
      .means("shares of each interval for speeding up and slowing down");
  type.field<&EaseInEaseOut::key>("key", inputOutput, {}).means("fractions, rising, one a pair of shares");
  type.field<&EaseInEaseOut::set_fraction>("set_fraction", inputOnly, 0).means("where between the keys");
  type.field<&EaseInEaseOut::modifiedFraction_changed>("modifiedFraction_changed", outputOnly, 0)
      .means("the fraction, eased");
}

}  // namespace pleura
