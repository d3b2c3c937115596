#pragma once

#include <pleura/nodes/core/node.h>
#include <pleura/nodes/standard/core/x3d_metadata_object.h>

namespace pleura {

/// Texts that inform about the node they stand in.
class MetadataString : public Node, public X3DMetadataObject {
 public:
  MFString value;

  static void declare(NodeType& type);
};

}  // namespace pleura
