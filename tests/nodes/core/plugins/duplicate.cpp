#include <pleura/nodes/core/plugin.h>

namespace pleura {
namespace {

class Trachea : public Node {
 public:
  static void declare(NodeType& type) {
    Node::declare(type);
    type.named("Trachea", "Pleura");
  }
};

class SecondLarynx : public Node {
 public:
  static void declare(NodeType& type) {
    Node::declare(type);
    type.named("Larynx", "Pleura");
  }
};

void registerNodes(NodeRegistry& registry) {
  registry.add<Trachea>();
  registry.add<SecondLarynx>();
}

}  // namespace
}  // namespace pleura

PLEURA_PLUGIN(pleura::registerNodes)
