#include <pleura/nodes/core/node_type.h>
#include <pleura/nodes/standard/core/metadata_double.h>

namespace pleura {

void MetadataDouble::declare(NodeType& type) {
  Node::declare(type);
  X3DMetadataObject::declare(type);
  type.named("MetadataDouble", "Core", 1)
      .containedIn("value")
      .means("numbers in double precision that inform about the node they stand in");
  using enum Access;
  type.field<&MetadataDouble::value>("value", inputOutput, {}).means("the values");
}

}  // namespace pleura
