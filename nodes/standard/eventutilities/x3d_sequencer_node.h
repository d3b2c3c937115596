#pragma once

#include <optional>

#include <pleura/nodes/core/event_handler.h>
#include <pleura/nodes/standard/core/x3d_child_node.h>

namespace pleura {

/// A node that sends values one by one: that of the last key not above set_fraction whenever it is another
/// one, or the next or the previous, around the ends.
class X3DSequencerNode : public X3DChildNode {
 public:
  MFFloat key;
  SFBool next;
  SFBool previous;
  SFFloat set_fraction;

  static void declare(NodeType& type);

 protected:
  void onInitialize() override;
  virtual std::size_t valueCount() = 0;
  virtual void send(std::size_t number) = 0;

 private:
  void hear();

  std::optional<std::size_t> current_;
  EventHandler onEvent_{[this] { hear(); }};
};

}  // namespace pleura
