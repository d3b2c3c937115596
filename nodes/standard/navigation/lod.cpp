#include <algorithm>

#include <pleura/nodes/core/node_type.h>
#include <pleura/nodes/standard/navigation/lod.h>

namespace pleura {

void LOD::declare(NodeType& type) {
  X3DGroupingNode::declare(type);
  type.named("LOD", "Navigation", 2).means("one child, by its distance from the viewer");
  using enum Access;
  type.field<&LOD::center>("center", initializeOnly, Vec3f::Zero())
      .measuredIn(Unit::length)
      .means("point from which the viewer's distance is taken");
  type.field<&LOD::forceTransitions>("forceTransitions", initializeOnly, false)
      .means("whether every change of level is made, however busy");
  type.field<&LOD::range>("range", initializeOnly, {})
      .measuredIn(Unit::length)
      .means("distances at which the levels change");
  type.field<&LOD::level_changed>("level_changed", outputOnly, 0)
      .atLeast(0)
      .means("number of the child that is shown");
}

void LOD::seeFrom(const Vec3f& viewer) {
  const float d = (viewer - center.getValue()).norm();
  const auto& limits = range.getValue();
  const auto level = std::upper_bound(limits.begin(), limits.end(), d) - limits.begin();
  const auto last = std::max<std::ptrdiff_t>(std::ssize(children.getValue()) - 1, 0);
  level_changed.setValueIfChanged(static_cast<std::int32_t>(std::min(level, last)), id);
}

std::span<const NodePtr> LOD::shown() {
  const std::span<const NodePtr> all = children.getValue();
  const auto level = static_cast<std::size_t>(level_changed.getValue());
  return level < all.size() ? all.subspan(level, 1) : std::span<const NodePtr>();
}

}  // namespace pleura
