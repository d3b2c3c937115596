#include <pleura/nodes/core/node_type.h>
#include <pleura/nodes/standard/shape/appearance.h>

namespace pleura {

void Appearance::declare(NodeType& type) {
  Node::declare(type);
  type.named("Appearance", "Shape", 1).containedIn("appearance").means("material and textures of a shape");
  using enum Access;
  type.field<&Appearance::acousticProperties>("acousticProperties", inputOutput, {})
      .means("how the surface reflects sound");
  type.field<&Appearance::alphaCutoff>("alphaCutoff", inputOutput, 0.5f)
      .within(0, 1)
      .means("opacity below which alphaMode MASK shows nothing");
  type.field<&Appearance::alphaMode>("alphaMode", inputOutput, "AUTO").means("AUTO, OPAQUE, MASK or BLEND");
  type.field<&Appearance::backMaterial>("backMaterial", inputOutput, {})
      .means("material of the back faces; none: that of the front");
  type.field<&Appearance::fillProperties>("fillProperties", inputOutput, {})
      .means("how the inside of faces is hatched");
  type.field<&Appearance::lineProperties>("lineProperties", inputOutput, {}).means("how lines are drawn");
  type.field<&Appearance::material>("material", inputOutput, {})
      .means("material of the faces, or of the front faces");
  type.field<&Appearance::pointProperties>("pointProperties", inputOutput, {}).means("how points are drawn");
  type.field<&Appearance::shaders>("shaders", inputOutput, {}).means("programs that draw the shape");
  type.field<&Appearance::surface>("surface", inputOutput, {})
      .extension()
      .means("how the shape feels; none: it can't be touched");
  type.field<&Appearance::texture>("texture", inputOutput, {}).means("picture on the surface");
  type.field<&Appearance::textureTransform>("textureTransform", inputOutput, {})
      .means("how the texture lies on the surface");
}

}  // namespace pleura
