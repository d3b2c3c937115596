#include <pleura/nodes/core/node_type.h>
#include <pleura/nodes/standard/core/world_info.h>

namespace pleura {

void WorldInfo::declare(NodeType& type) {
  Node::declare(type);
  type.named("WorldInfo", "Core", 1).means("title of the scene and words about it");
  using enum Access;
  type.field<&WorldInfo::info>("info", inputOutput, {}).means("words about the scene");
  type.field<&WorldInfo::title>("title", inputOutput, {}).means("title of the scene");
}

}  // namespace pleura
