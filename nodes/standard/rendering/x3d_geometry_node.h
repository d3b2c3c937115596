#pragma once

#include <pleura/nodes/core/node.h>
#include <pleura/nodes/standard/rendering/render_mesh.h>

namespace pleura {

/// A shape without its looks.
class X3DGeometryNode : public Node {
 public:
  /// The shape as a renderer takes it, brought up to date first. Only what changed since the last call is
  /// computed; nothing is allocated unless the topology changed. Empty for what is drawn in another way, as
  /// Text.
  const RenderMesh& renderMesh() {
    updateMesh(mesh_);
    return mesh_;
  }

 protected:
  virtual void updateMesh(RenderMesh&) {}

 private:
  RenderMesh mesh_;
};

}  // namespace pleura
