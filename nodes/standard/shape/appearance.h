#pragma once

#include <pleura/nodes/core/typed_node_field.h>
#include <pleura/nodes/standard/shape/line_properties.h>
#include <pleura/nodes/standard/shape/point_properties.h>
#include <pleura/nodes/standard/shape/x3d_appearance_node.h>
#include <pleura/nodes/standard/shape/x3d_material_node.h>
#include <pleura/nodes/standard/shape/x3d_surface_node.h>

namespace pleura {

/// Material and textures of a shape, and how it feels.
class Appearance : public X3DAppearanceNode {
 public:
  SFNode acousticProperties;
  SFFloat alphaCutoff;
  SFString alphaMode;
  TypedSFNode<X3DMaterialNode> backMaterial;
  SFNode fillProperties;
  TypedSFNode<LineProperties> lineProperties;
  TypedSFNode<X3DMaterialNode> material;
  TypedSFNode<PointProperties> pointProperties;
  MFNode shaders;
  TypedSFNode<X3DSurfaceNode> surface;
  SFNode texture;
  SFNode textureTransform;

  static void declare(NodeType& type);
};

}  // namespace pleura
