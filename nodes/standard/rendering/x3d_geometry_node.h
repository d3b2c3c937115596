#pragma once

#include <pleura/nodes/core/node.h>
#include <pleura/nodes/standard/rendering/render_mesh.h>

namespace pleura {

/// A shape without its looks, and how it is touched: one entry a haptic device, in the shape's own frame (the
/// fields are H3D's).
class X3DGeometryNode : public Node {
 public:
  MFBool isTouched;
  MFVec3f force;
  MFVec3f contactPoint;
  MFVec3f contactNormal;
  MFFloat contactDepth;

  static void declare(NodeType& type);

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
