#include <pleura/nodes/core/node_type.h>
#include <pleura/nodes/standard/core/metadata_float.h>

namespace pleura {

void MetadataFloat::declare(NodeType& type) {
  Node::declare(type);
  X3DMetadataObject::declare(type);
  type.named("MetadataFloat", "Core", 1)
      .containedIn("value")
      .means("numbers that inform about the node they stand in");
  using enum Access;
  type.field<&MetadataFloat::value>("value", inputOutput, {}).means("the values");
}

}  // namespace pleura
