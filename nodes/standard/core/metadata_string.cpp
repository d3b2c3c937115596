#include <pleura/nodes/core/node_type.h>
#include <pleura/nodes/standard/core/metadata_string.h>

namespace pleura {

void MetadataString::declare(NodeType& type) {
  Node::declare(type);
  X3DMetadataObject::declare(type);
  type.named("MetadataString", "Core", 1)
      .containedIn("value")
      .means("texts that inform about the node they stand in");
  using enum Access;
  type.field<&MetadataString::value>("value", inputOutput, {}).means("the values");
}

}  // namespace pleura
