#include <pleura/nodes/core/node_type.h>
#include <pleura/nodes/standard/core/x3d_bindable_node.h>

namespace pleura {

void X3DBindableNode::declare(NodeType& type) {
  Node::declare(type);
  using enum Access;
  type.field<&X3DBindableNode::set_bind>("set_bind", inputOnly, false)
      .means("true puts the node on top of its stack, false takes it off");
  type.field<&X3DBindableNode::bindTime>("bindTime", outputOnly, 0)
      .measuredIn(Unit::time)
      .means("when it was bound last");
  type.field<&X3DBindableNode::isBound>("isBound", outputOnly, false).means("whether it is the one in use");
}

X3DBindableNode::~X3DBindableNode() {
  if (stack_ != nullptr) stack_->unbind(this);
}

void X3DBindableNode::onInitialize() {
  stack_ = &context().bindables(kind());
  onBind_.hears(*this, set_bind);
  if (stack_->top() == nullptr) stack_->bind(this);
}

void X3DBindableNode::onBound(bool bound) {
  isBound.setValue(bound, id);
  bindTime.setValue(context().time.getValue(), id);
}

}  // namespace pleura
