#include <algorithm>
#include <numeric>
#include <stdexcept>

#include <pleura/nodes/core/scene_context.h>
#include <pleura/nodes/thorax/contacts_node.h>

namespace pleura {

void ContactsNode::declare(NodeType& type) {
  Node::declare(type);
  using enum Access;
  type.field<&ContactsNode::inflation>("inflation", inputOutput, 0).means("0 at FRC, 1 at TLC");
  type.field<&ContactsNode::organ>("organ", initializeOnly, {}).means("whose points are held");
  type.field<&ContactsNode::fillsBetween>("fillsBetween", inputOutput, true)
      .means(
          "whether the points that no wall moves follow smoothly between; if not, the deformer moves them");
  type.field<&ContactsNode::shape>("shape", outputOnly, {})
      .measuredIn(Unit::length)
      .means("where all of the organ's points are now, those between filled in smoothly");
  type.field<&ContactsNode::index>("index", outputOnly, {})
      .means("the organ's points that are held or follow between");
  type.field<&ContactsNode::point>("point", outputOnly, {})
      .measuredIn(Unit::length)
      .means("where they are now, one for each of index");
}

void ContactsNode::onInitialize() {
  auto* held = organ.get();
  if (held == nullptr) return context().warn(*this, "organ is missing: a DeformableShape2 is expected");
  held->origCoord.routeNoEvent(shape, id);
  inflation.routeNoEvent(shape, id);
  for (Field* mover : movers()) mover->routeNoEvent(shape, id);
  held->origCoord.routeNoEvent(index, id);
  fillsBetween.routeNoEvent(index, id);
  shape.routeNoEvent(point, id);
  fillsBetween.routeNoEvent(point, id);
  index.touch();
  held->origCoord.touch();
}

bool ContactsNode::isBound() {
  auto* held = organ.get();
  if (held == nullptr) return false;
  held->origCoord.upToDate();
  if (held->origCoord.getStamp() == boundStamp_) return usable_;
  boundStamp_ = held->origCoord.getStamp();
  try {
    usable_ = false;
    bind();
    usable_ = true;
  } catch (const std::invalid_argument& refused) {
    context().warn(*this, refused.what());
  }
  return usable_;
}

void ContactsNode::evaluateIndex(std::vector<int>& out) {
  out.clear();
  if (!isBound()) return;
  if (!fillsBetween.getValue()) return out.assign(driven().begin(), driven().end());
  out.resize(organ.get()->origCoord.size());
  std::iota(out.begin(), out.end(), 0);
}

void ContactsNode::evaluateShape(std::vector<Vec3f>& out) {
  out.resize(isBound() ? organ.get()->origCoord.size() : 0);
  if (!out.empty()) follow(out);
}

void ContactsNode::evaluatePoint(std::vector<Vec3f>& out) {
  const auto& all = shape.getValue(id);
  if (fillsBetween.getValue() || all.empty()) return void(out = all);
  out.resize(driven().size());
  std::transform(driven().begin(), driven().end(), out.begin(),
                 [&all](int i) { return all[static_cast<std::size_t>(i)]; });
}

}  // namespace pleura
