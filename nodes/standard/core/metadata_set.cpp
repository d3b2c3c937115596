#include <pleura/nodes/core/node_type.h>
#include <pleura/nodes/standard/core/metadata_set.h>

namespace pleura {

void MetadataSet::declare(NodeType& type) {
  Node::declare(type);
  X3DMetadataObject::declare(type);
  type.named("MetadataSet", "Core", 1)
      .containedIn("value")
      .means("metadata nodes that inform about the node they stand in");
  using enum Access;
  type.field<&MetadataSet::value>("value", inputOutput, {}).means("the metadata nodes");
}

}  // namespace pleura
