#include <pleura/nodes/core/plugin.h>
#include <pleura/nodes/deformable/chainmail_deformer.h>
#include <pleura/nodes/deformable/finite_element_deformer.h>
#include <pleura/nodes/deformable/spring_deformer.h>
#include <pleura/nodes/thorax/contact_points.h>
#include <pleura/nodes/thorax/deformable_shape2.h>
#include <pleura/nodes/thorax/diaphragm_contacts.h>
#include <pleura/nodes/thorax/fitted_transform.h>
#include <pleura/nodes/thorax/lung_contacts.h>
#include <pleura/nodes/thorax/organ_deformation.h>
#include <pleura/nodes/thorax/pleural_wall_node.h>
#include <pleura/nodes/thorax/respiration.h>
#include <pleura/nodes/thorax/rot_transform.h>
#include <pleura/nodes/thorax/skin_deformer.h>

namespace pleura {

void registerThoraxNodes(NodeRegistry& registry) {
  registry.add<ChainmailDeformer>();
  registry.add<ContactPoints>();
  registry.add<DeformableShape2>();
  registry.add<DiaphragmContacts>();
  registry.add<FiniteElementDeformer>();
  registry.add<FittedTransform>();
  registry.add<LungContacts>();
  registry.add<OrganDeformation>();
  registry.add<PleuralWallNode>();
  registry.add<Respiration>();
  registry.add<RotTransform>();
  registry.add<SkinDeformer>();
  registry.add<SpringDeformer>();
}

}  // namespace pleura

PLEURA_PLUGIN(pleura::registerThoraxNodes)
