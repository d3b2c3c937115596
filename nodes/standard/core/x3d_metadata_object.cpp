#include <pleura/nodes/core/node_type.h>
#include <pleura/nodes/standard/core/x3d_metadata_object.h>

namespace pleura {

void X3DMetadataObject::declare(NodeType& type) {
  using enum Access;
  type.field<&X3DMetadataObject::name>("name", inputOutput, {}).means("what it informs about");
  type.field<&X3DMetadataObject::reference>("reference", inputOutput, {})
      .means("the standard or vocabulary that defines the name");
}

}  // namespace pleura
