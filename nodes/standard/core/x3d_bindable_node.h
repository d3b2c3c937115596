#pragma once

#include <pleura/nodes/core/event_handler.h>
#include <pleura/nodes/core/scene_context.h>
#include <pleura/nodes/standard/core/x3d_child_node.h>

namespace pleura {

/// A node of which one of its kind is in use: the one on top of its stack in the SceneContext (X3D 7.2.2).
/// The first of a kind that a file has is bound when it is read; what Inlines have counts where it has none.
class X3DBindableNode : public X3DChildNode, public Bindable {
 public:
  SFBool set_bind;
  SFTime bindTime;
  SFBool isBound;

  ~X3DBindableNode() override;
  static void declare(NodeType& type);

  void onBound(bool bound) override;
  /// What BindableStack it belongs on.
  virtual std::string_view kind() const = 0;

 protected:
  void onInitialize() override;

 private:
  BindableStack* stack_ = nullptr;
  EventHandler onBind_{[this] { set_bind.getValue(id) ? stack_->bind(this) : stack_->unbind(this); }};
};

}  // namespace pleura
