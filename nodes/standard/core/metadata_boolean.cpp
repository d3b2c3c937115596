#include <pleura/nodes/core/node_type.h>
#include <pleura/nodes/standard/core/metadata_boolean.h>

namespace pleura {

void MetadataBoolean::declare(NodeType& type) {
  Node::declare(type);
  X3DMetadataObject::declare(type);
  type.named("MetadataBoolean", "Core", 1)
      .containedIn("value")
      .means("booleans that inform about the node they stand in");
  using enum Access;
  type.field<&MetadataBoolean::value>("value", inputOutput, {}).means("the values");
}

}  // namespace pleura
