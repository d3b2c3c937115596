#pragma once

#include <pleura/nodes/core/node.h>
#include <pleura/nodes/standard/core/x3d_metadata_object.h>

namespace pleura {

/// Booleans that inform about the node they stand in.
class MetadataBoolean : public Node, public X3DMetadataObject {
 public:
  MFBool value;

  static void declare(NodeType& type);
};

}  // namespace pleura
