#include <pleura/nodes/core/scene_context.h>
#include <pleura/nodes/thorax/organ_deformation.h>

namespace pleura {

void OrganDeformation::declare(NodeType& type) {
  Node::declare(type);
  type.named("OrganDeformation", "Pleura").means("chooses how an organ deforms between its contacts");
  using enum Access;
  type.field<&OrganDeformation::contacts>("contacts", initializeOnly, {})
      .means("the LungContacts or DiaphragmContacts that hold the organ");
  type.field<&OrganDeformation::deformer>("deformer", initializeOnly, {})
      .means("moves the points that no wall moves");
}

void OrganDeformation::onInitialize() {
  auto* held = contacts.get();
  auto* organ = held != nullptr ? held->organ.get() : nullptr;
  if (organ == nullptr)
    return context().warn(*this, "contacts is missing: LungContacts or DiaphragmContacts are expected");
  if (deformer.get() == nullptr) return context().warn(*this, "deformer is missing");
  held->fillsBetween.setValue(false);
  organ->deformer.setValue(deformer.getValue(id));
}

}  // namespace pleura
