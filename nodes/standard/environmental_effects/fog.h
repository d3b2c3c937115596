#pragma once

#include <pleura/nodes/standard/core/x3d_bindable_node.h>
#include <pleura/nodes/standard/environmental_effects/x3d_fog_object.h>

namespace pleura {

/// Haze that hides what is far away.
class Fog : public X3DBindableNode, public X3DFogObject {
 public:
  static void declare(NodeType& type);

 protected:
  std::string_view kind() const override { return "Fog"; }
};

}  // namespace pleura
