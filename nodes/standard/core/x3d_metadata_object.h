#pragma once

#include <pleura/nodes/core/node_type.h>

namespace pleura {

/// What all metadata nodes have in common: what it is about, and by which standard.
class X3DMetadataObject {
 public:
  SFString name;
  SFString reference;

  static void declare(NodeType& type);
};

}  // namespace pleura
