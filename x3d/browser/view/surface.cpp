#include <pleura/nodes/standard/shape/appearance.h>
#include <pleura/nodes/standard/shape/line_properties.h>
#include <pleura/nodes/standard/shape/material.h>
#include <pleura/nodes/standard/shape/point_properties.h>
#include <pleura/nodes/standard/shape/two_sided_material.h>
#include <pleura/nodes/standard/shape/unlit_material.h>
#include <pleura/x3d/browser/view/surface.h>

namespace pleura {

namespace {

template <class LitMaterial>
render::Material lit(LitMaterial& node) {
  render::Material material;
  material.diffuseColor = node.diffuseColor.getValue();
  material.specularColor = node.specularColor.getValue();
  material.emissiveColor = node.emissiveColor.getValue();
  material.ambientIntensity = node.ambientIntensity.getValue();
  material.shininess = node.shininess.getValue();
  material.transparency = node.transparency.getValue();
  return material;
}

render::Material unlit(const RGB& color, float transparency) {
  render::Material material;
  material.lit = false;
  material.emissiveColor = color;
  material.transparency = transparency;
  return material;
}

render::Material materialOf(X3DMaterialNode* node) {
  if (auto* phong = dynamic_cast<Material*>(node)) return lit(*phong);
  if (auto* twoSided = dynamic_cast<TwoSidedMaterial*>(node)) return lit(*twoSided);
  if (auto* plain = dynamic_cast<UnlitMaterial*>(node))
    return unlit(plain->emissiveColor.getValue(), plain->transparency.getValue());
  return unlit(RGB::Ones(), 0);
}

}  // namespace

Surface surfaceOf(X3DShapeNode& shape) {
  auto* appearance = dynamic_cast<Appearance*>(shape.appearance.get());
  if (appearance == nullptr) return {materialOf(nullptr)};
  Surface surface{materialOf(appearance->material.get())};
  if (auto* line = appearance->lineProperties.get(); line != nullptr && line->applied.getValue())
    surface.size = std::max(1.f, line->linewidthScaleFactor.getValue());
  if (auto* point = appearance->pointProperties.get())
    surface.size = std::max(1.f, point->pointSizeScaleFactor.getValue());
  return surface;
}

}  // namespace pleura
