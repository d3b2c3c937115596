#pragma once

#include <pleura/nodes/core/node.h>
#include <pleura/nodes/standard/core/x3d_metadata_object.h>

namespace pleura {

/// Whole numbers that inform about the node they stand in.
class MetadataInteger : public Node, public X3DMetadataObject {
 public:
  MFInt32 value;

  static void declare(NodeType& type);
};

}  // namespace pleura
