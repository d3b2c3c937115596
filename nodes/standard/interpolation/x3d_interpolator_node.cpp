#include <algorithm>

#include <pleura/nodes/core/node_type.h>
#include <pleura/nodes/core/scene_context.h>
#include <pleura/nodes/standard/interpolation/x3d_interpolator_node.h>

namespace pleura {

void X3DInterpolatorNode::declare(NodeType& type) {
  Node::declare(type);
  using enum Access;
  type.field<&X3DInterpolatorNode::key>("key", inputOutput, {}).means("fractions, rising, one a key value");
  type.field<&X3DInterpolatorNode::set_fraction>("set_fraction", inputOnly, 0)
      .means("where between the keys");
}

std::optional<KeyInterval> X3DInterpolatorNode::locate(float fraction, Field& keyValue, std::size_t frames,
                                                       bool isComplete) {
  if (watch_.changed(key, keyValue)) check(isComplete);
  const std::span<const float> keys = key.getValue();
  frames = std::min(frames, keys.size());
  if (frames == 0) return std::nullopt;
  return findKeyInterval(keys.first(frames), fraction);
}

void X3DInterpolatorNode::check(bool isComplete) {
  const auto& keys = key.getValue();
  const bool isRising = std::is_sorted(keys.begin(), keys.end());
  if ((isRising && isComplete) || hasWarned_ || !isInitialized()) return;
  hasWarned_ = true;
  context().warn(*this, isRising ? "keyValue has not as many values as key asks for" : "key does not rise");
}

}  // namespace pleura
