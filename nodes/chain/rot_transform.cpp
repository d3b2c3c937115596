#include <pleura/nodes/chain/rot_transform.h>
#include <pleura/nodes/core/node_type.h>
#include <pleura/nodes/core/scene_context.h>

namespace pleura::chain {

void RotTransform::declare(NodeType& type) {
  pleura::RotTransform::declare(type);
  type.means("a rib that turns about its joint; or, with coord1 and coord2, which points follow which");
  using enum Access;
  type.field<&RotTransform::coord1>("coord1", inputOutput, {})
      .measuredIn(Unit::length)
      .means("points of object 1, which is followed; routed from its Coordinate, taken at rest");
  type.field<&RotTransform::coord2>("coord2", inputOutput, {})
      .measuredIn(Unit::length)
      .means("points of object 2, which follows");
  type.field<&RotTransform::dist>("dist", inputOutput, {})
      .measuredIn(Unit::length)
      .means(
          "farthest at which a point follows; at which it is rigid; least and greatest z; least x "
          "considered");
  type.field<&RotTransform::touch>("touch", inputOutput, {})
      .means("pairs: a point of object 1, the point of object 2 that follows it; to a rib, its contacts");
  type.field<&RotTransform::rigid_touch>("rigid_touch", inputOutput, {})
      .means("pairs: a point of object 1, the point of object 2 that is made rigid");
}

void RotTransform::onInitialize() {
  pleura::RotTransform::onInitialize();
  for (Touch* found : {&touch, &rigid_touch})
    for (Field* input :
         {static_cast<Field*>(&coord1), static_cast<Field*>(&coord2), static_cast<Field*>(&dist)})
      input->route(*found, id);
  touch.routeNoEvent(followed_);
  followed_.routeNoEvent(points);
}

void RotTransform::tell(const std::string& message) { context().warn(*this, message); }

void RotTransform::Followed::update() {
  value.clear();
  auto& contacts = static_cast<Touch&>(*routes_in[0]);
  contacts.upToDate();
  contacts.forEach([&](Touch& contact) {
    const auto& followed = contact.found().followed;
    value.insert(value.end(), followed.begin(), followed.end());
  });
}

}  // namespace pleura::chain
