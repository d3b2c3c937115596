#include <pleura/nodes/core/node_type.h>
#include <pleura/nodes/standard/lighting/x3d_light_node.h>

namespace pleura {

void X3DLightNode::declare(NodeType& type) {
  Node::declare(type);
  using enum Access;
  type.field<&X3DLightNode::ambientIntensity>("ambientIntensity", inputOutput, 0)
      .within(0, 1)
      .means("how much it lights from all sides");
  type.field<&X3DLightNode::color>("color", inputOutput, RGB(1, 1, 1))
      .within(0, 1)
      .means("colour of the light");
  type.field<&X3DLightNode::intensity>("intensity", inputOutput, 1)
      .atLeast(0)
      .means("brightness of the light");
  type.field<&X3DLightNode::on>("on", inputOutput, true).means("whether the light is lit");
  type.field<&X3DLightNode::shadowIntensity>("shadowIntensity", inputOutput, 1)
      .within(0, 1)
      .means("how dark the shadows are");
  type.field<&X3DLightNode::shadows>("shadows", inputOutput, false).means("whether the light casts shadows");
}

}  // namespace pleura
