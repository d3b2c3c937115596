#include <algorithm>

#include <pleura/nodes/core/node_type.h>
#include <pleura/nodes/standard/rendering/color.h>

namespace pleura {

void Color::declare(NodeType& type) {
  Node::declare(type);
  type.named("Color", "Rendering", 1).containedIn("color").means("colours of a geometry");
  using enum Access;
  type.field<&Color::color>("color", inputOutput, {}).within(0, 1).means("colours");
}

std::span<const RGBA> Color::colors() {
  if (watch_.changed(color)) {
    const auto& from = color.getValue();
    colors_.resize(from.size());
    std::transform(from.begin(), from.end(), colors_.begin(),
                   [](const RGB& p) { return RGBA(p.x(), p.y(), p.z(), 1); });
  }
  return colors_;
}

}  // namespace pleura
