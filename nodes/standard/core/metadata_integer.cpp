#include <pleura/nodes/core/node_type.h>
#include <pleura/nodes/standard/core/metadata_integer.h>

namespace pleura {

void MetadataInteger::declare(NodeType& type) {
  Node::declare(type);
  X3DMetadataObject::declare(type);
  type.named("MetadataInteger", "Core", 1)
      .containedIn("value")
      .means("whole numbers that inform about the node they stand in");
  using enum Access;
  type.field<&MetadataInteger::value>("value", inputOutput, {}).means("the values");
}

}  // namespace pleura
