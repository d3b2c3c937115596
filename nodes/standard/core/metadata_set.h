#pragma once

#include <pleura/nodes/core/node.h>
#include <pleura/nodes/standard/core/x3d_metadata_object.h>

namespace pleura {

/// Metadata nodes that inform about the node they stand in.
class MetadataSet : public Node, public X3DMetadataObject {
 public:
  MFNode value;

  static void declare(NodeType& type);
};

}  // namespace pleura
