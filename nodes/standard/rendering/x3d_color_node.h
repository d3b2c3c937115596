#pragma once

#include <span>

#include <pleura/nodes/standard/rendering/x3d_geometric_property_node.h>

namespace pleura {

/// The colours of a geometry.
class X3DColorNode : public X3DGeometricPropertyNode {
 public:
  /// Brought up to date first; valid until the next call.
  virtual std::span<const RGBA> colors() = 0;
  /// The field they are in, whose stamp tells of changes.
  virtual Field& source() = 0;
};

}  // namespace pleura
