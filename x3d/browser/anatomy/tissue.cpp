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

/// How it feels, in parts of what the device can do: on one that holds 400 N/m a lung has 80 N/m under the
/// tip (a lung under 5 mm has 40-120), the diaphragm 180, bone all there is.
NodePtr surfaceOf(const NodeMaker& maker, Tissue tissue) {
  const auto make = [&maker](const char* type, float stiffness, float damping, float friction) {
    auto surface = maker.make(type);
    maker.set<SFFloat>(surface, "stiffness", stiffness);
    maker.set<SFFloat>(surface, "damping", damping);
    maker.set<SFFloat>(surface, "staticFriction", friction);
    maker.set<SFFloat>(surface, "dynamicFriction", friction);
    return surface;
  };
  switch (tissue) {
    case Tissue::bone:
      return make("FrictionalSurface", 1, 0, 0.2f);
    case Tissue::cartilage:
      return make("FrictionalSurface", 0.8f, 0, 0.1f);
    case Tissue::muscle:
      return make("TissueSurface", 0.45f, 0.1f, 0);
    case Tissue::lung:
      return make("TissueSurface", 0.2f, 0.1f, 0);
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
  auto appearance = maker.make("Appearance");
  maker.put(appearance, "material", material);
  maker.put(appearance, "surface", surfaceOf(maker, tissue));
  return appearance;
}

}  // namespace pleura
