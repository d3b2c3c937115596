#pragma once

#include <pleura/nodes/core/node.h>
#include <pleura/nodes/standard/core/x3d_metadata_object.h>

namespace pleura {

/// Numbers that inform about the node they stand in.
class MetadataFloat : public Node, public X3DMetadataObject {
 public:
  MFFloat value;

  static void declare(NodeType& type);
};

}  // namespace pleura
