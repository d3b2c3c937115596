#include <pleura/nodes/deformable/contact/nearest_contacts.h>
#include <pleura/nodes/thorax/contact_points.h>

namespace pleura {

void ContactPoints::declare(NodeType& type) {
  Node::declare(type);
  type.named("ContactPoints", "Pleura").means("which points of one object follow which of another");
  using enum Access;
  type.field<&ContactPoints::coord1>("coord1", inputOutput, {})
      .measuredIn(Unit::length)
      .means("points of object 1, which is followed");
  type.field<&ContactPoints::coord2>("coord2", inputOutput, {})
      .measuredIn(Unit::length)
      .means("points of object 2, which follows");
  type.field<&ContactPoints::dist>("dist", inputOutput, {0.005f, 0, -1000, 1000, -1000})
      .measuredIn(Unit::length)
      .means(
          "farthest at which a point follows; at which it is rigid; least and greatest z; least x "
          "considered");
  type.field<&ContactPoints::touch>("touch", outputOnly, {})
      .means("pairs: a point of object 1, the point of object 2 that follows it");
  type.field<&ContactPoints::rigid_touch>("rigid_touch", outputOnly, {})
      .means("pairs: a point of object 1, the point of object 2 that is made rigid");
}

ContactPoints::ContactPoints() {
  for (Pairs* pairs : {&touch, &rigid_touch})
    for (Field* input :
         {static_cast<Field*>(&coord1), static_cast<Field*>(&coord2), static_cast<Field*>(&dist)})
      input->routeNoEvent(*pairs);
}

void ContactPoints::Pairs::update() {
  value.clear();
  const auto& limits = static_cast<MFFloat*>(routes_in[2])->getValue();
  if (limits.size() != 5) return;
  const ContactRegion region{limits[2], limits[3], limits[4]};
  const auto contacts =
      nearestContacts(static_cast<MFVec3f*>(routes_in[0])->getValue(),
                      static_cast<MFVec3f*>(routes_in[1])->getValue(), region, limits[distance_]);
  for (const auto& contact : contacts) {
    value.push_back(contact.first);
    value.push_back(contact.second);
  }
}

}  // namespace pleura
