#include "gate.h"

#include <pleura/nodes/core/node_registry.h>
#include <pleura/nodes/core/node_type.h>
#include <pleura/nodes/core/plugin.h>
#include <pleura/nodes/standard/core/x3d_child_node.h>

/// A node of one's own: what flows in flows out while it is open.
class Valve : public pleura::X3DChildNode {
 public:
  pleura::SFBool open;
  pleura::SFFloat pressure;
  Gate flow;

  static void declare(pleura::NodeType& type) {
    using enum pleura::Access;
    pleura::Node::declare(type);
    type.named("Valve", "Package").means("lets through what it is given while it is open");
    type.field<&Valve::open>("open", inputOutput, false).means("whether it is open");
    type.field<&Valve::pressure>("pressure", inputOutput, 0).means("what it is given");
    type.field<&Valve::flow>("flow", outputOnly, 0).means("what it lets through");
  }

 protected:
  void onInitialize() override {
    open.route(flow, id);
    pressure.route(flow, id);
  }
};

static void registerValve(pleura::NodeRegistry& registry) { registry.add<Valve>(); }

PLEURA_PLUGIN(registerValve)
