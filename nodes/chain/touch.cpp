#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include <pleura/nodes/chain/rot_transform.h>
#include <pleura/nodes/chain/touch.h>
#include <pleura/nodes/thorax/deformable_shape2.h>

namespace pleura::chain {

MFVec3f& RestCoord::rest() {
  if (routes_in.empty()) return *this;
  auto& source = static_cast<MFVec3f&>(*routes_in[0]);
  for (const Field* mover : source.getRoutesIn())
    if (auto* organ = dynamic_cast<pleura::DeformableShape2*>(mover->getOwner())) return organ->origCoord;
  return source;
}

Touch* TouchInput::asTouch(Field* field) { return dynamic_cast<Touch*>(field); }

void TouchInput::update() {
  value.clear();
  forEach([&](Touch& touch) {
    if (&touch == this) return;
    const auto& part = touch.getValue();
    value.insert(value.end(), part.begin(), part.end());
  });
}

bool TouchInput::acceptsInput(const Field& from, std::size_t, std::string& why) const {
  if (dynamic_cast<const Touch*>(&from) != nullptr) return true;
  why = "touch or rigid_touch of a RotTransform";
  return false;
}

bool Touch::acceptsInput(const Field& from, std::size_t index, std::string& why) const {
  auto& node = static_cast<RotTransform&>(*getOwner());
  const bool isCompared = &from == &node.coord1 || &from == &node.coord2 || &from == &node.dist;
  return isCompared || TouchInput::acceptsInput(from, index, why);
}

void Touch::update() {
  bool isGiven = false;
  forEach([&](Touch&) { isGiven = true; });
  if (isGiven) return TouchInput::update();
  auto& node = static_cast<RotTransform&>(*getOwner());
  MFVec3f& rest1 = node.coord1.rest();
  MFVec3f& rest2 = node.coord2.rest();
  const auto& object1 = rest1.getValue();
  const auto& object2 = rest2.getValue();
  const std::array stamps{rest1.getStamp(), rest2.getStamp(), node.dist.getStamp()};
  if (stamps == stamps_ || (object1.empty() && object2.empty())) return;
  stamps_ = stamps;
  find(object1, object2);
}

void Touch::find(const std::vector<Vec3f>& object1, const std::vector<Vec3f>& object2) {
  auto& node = static_cast<RotTransform&>(*getOwner());
  value.clear();
  found_ = {};
  const auto& dist = node.dist.getValue();
  if (dist.size() != 5 || !std::all_of(dist.begin(), dist.end(), [](float d) { return std::isfinite(d); }))
    return node.tell("dist: five finite numbers are expected");
  const float reach = dist[distance_];
  found_.contacts = nearestContacts(object1, object2, {dist[2], dist[3], dist[4]}, reach);
  if (found_.contacts.empty() && distance_ == 0)
    node.tell(fmt::format("dist: no point of coord2 is within {} of one of coord1", reach));
  for (const auto& contact : found_.contacts) {
    found_.followed.push_back(object1[static_cast<std::size_t>(contact.first)]);
    value.push_back(contact.first);
    value.push_back(contact.second);
  }
}

}  // namespace pleura::chain
