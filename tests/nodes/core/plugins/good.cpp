#include <pleura/nodes/core/plugin.h>

namespace pleura {
namespace {

class Larynx : public Node {
 public:
  SFFloat pitch;

  static void declare(NodeType& type) {
    Node::declare(type);
    type.named("Larynx", "Pleura").means("speaks");
    type.field<&Larynx::pitch>("pitch", Access::inputOutput, 110).measuredIn(Unit::frequency);
  }
};

void registerNodes(NodeRegistry& registry) { registry.add<Larynx>(); }

}  // namespace
}  // namespace pleura

PLEURA_PLUGIN(pleura::registerNodes)
