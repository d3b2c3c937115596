#include <pleura/x3d/browser/anatomy/tissue.h>

namespace pleura {

namespace {

struct Look {
  RGB diffuse;
  RGB specular;
  float shininess;
  float transparency;
};

Look lookOf(Tissue tissue) {
  switch (tissue) {
    case Tissue::bone:
      return {{0.87f, 0.82f, 0.70f}, {0.16f, 0.15f, 0.13f}, 0.25f, 0};
    case Tissue::cartilage:
      return {{0.70f, 0.78f, 0.80f}, {0.25f, 0.27f, 0.28f}, 0.35f, 0};
    case Tissue::muscle:
      return {{0.62f, 0.22f, 0.19f}, {0.18f, 0.10f, 0.09f}, 0.30f, 0};
    case Tissue::lung:
      return {{0.90f, 0.56f, 0.55f}, {0.20f, 0.16f, 0.16f}, 0.30f, 0.45f};
  }
  return {};
}

}  // namespace

NodePtr appearanceOf(const NodeMaker& maker, Tissue tissue) {
  const Look look = lookOf(tissue);
  const auto material = maker.make("Material");
  maker.set<SFColor>(material, "diffuseColor", look.diffuse);
  maker.set<SFColor>(material, "specularColor", look.specular);
  maker.set<SFFloat>(material, "shininess", look.shininess);
  maker.set<SFFloat>(material, "transparency", look.transparency);
  const auto appearance = maker.make("Appearance");
  maker.put(appearance, "material", material);
  return appearance;
}

}  // namespace pleura
