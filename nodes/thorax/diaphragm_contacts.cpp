#include <algorithm>
#include <limits>
#include <stdexcept>

#include <pleura/nodes/thorax/diaphragm_contacts.h>

namespace pleura {

void DiaphragmContacts::declare(NodeType& type) {
  ContactsNode::declare(type);
  type.named("DiaphragmContacts", "Pleura")
      .means("holds the diaphragm to the walls and to its descending tendon");
  using enum Access;
  const DomeMotion byDefault;
  type.field<&DiaphragmContacts::walls>("walls", initializeOnly, {})
      .means("the PleuralWalls, left and right");
  type.field<&DiaphragmContacts::part>("part", initializeOnly, {})
      .within(0, 3)
      .means("of each point: 0 central tendon, 1 dome, 2 zone of apposition, 3 rim");
  type.field<&DiaphragmContacts::s>("s", initializeOnly, {})
      .within(0, 2)
      .means("of each point: 0 at the apex, 1 at the edge of the dome, 2 at the rim");
  type.field<&DiaphragmContacts::descent>("descent", initializeOnly, static_cast<float>(byDefault.descent))
      .measuredIn(Unit::length)
      .within(0, 0.2)
      .means("of the tendon's centre from FRC to TLC");
  type.field<&DiaphragmContacts::forward>("forward", initializeOnly, static_cast<float>(byDefault.forward))
      .measuredIn(Unit::length)
      .within(-0.1, 0.1)
      .means("shift of the tendon's centre to the front from FRC to TLC");
  type.field<&DiaphragmContacts::tilt>("tilt", initializeOnly, static_cast<float>(byDefault.tilt))
      .measuredIn(Unit::angle)
      .within(-1, 1)
      .means("of the tendon from FRC to TLC, its back going down more than its front");
  type.field<&DiaphragmContacts::foldDrop>("foldDrop", initializeOnly, static_cast<float>(byDefault.foldDrop))
      .measuredIn(Unit::length)
      .within(0, 0.2)
      .means("how far the edge of the dome goes down the wall from FRC to TLC");
  type.field<&DiaphragmContacts::domeHeight>("domeHeight", outputOnly, 0)
      .measuredIn(Unit::length)
      .means("height of the central tendon's highest point in the subject's frame");
}

void DiaphragmContacts::onInitialize() {
  ContactsNode::onInitialize();
  if (organ.get() != nullptr) organ.get()->deformedCoord.routeNoEvent(domeHeight, id);
  domeHeight.touch();
  if (organ.get() != nullptr) organ.get()->deformedCoord.touch();
}

void DiaphragmContacts::DomeHeight::update() {
  const auto& tags = static_cast<DiaphragmContacts*>(getOwner())->part.getValue();
  const auto& points = static_cast<MFVec3f*>(routes_in[0])->getValue();
  float highest = -std::numeric_limits<float>::max();
  for (std::size_t i = 0; i < std::min(tags.size(), points.size()); ++i)
    if (tags[i] == static_cast<int>(DiaphragmPart::Tendon)) highest = std::max(highest, points[i].y());
  value = highest;
}

PleuralWallNode& DiaphragmContacts::wall(std::size_t side) {
  auto* node =
      walls.size() == 2 ? dynamic_cast<PleuralWallNode*>(walls.getValueByIndex(side).get()) : nullptr;
  if (node == nullptr) throw std::invalid_argument("walls: two PleuralWalls are expected, left and right");
  return *node;
}

std::vector<Field*> DiaphragmContacts::movers() {
  std::vector<Field*> points;
  for (const auto& each : walls.getValue())
    if (auto* node = dynamic_cast<PleuralWallNode*>(each.get())) points.push_back(&node->points);
  return points;
}

Diaphragm DiaphragmContacts::atRest() {
  Diaphragm rest;
  rest.mesh = organ.get()->rest();
  const std::size_t count = rest.mesh.points.size();
  if (part.size() != count || s.size() != count)
    throw std::invalid_argument("part and s: one value for each of the diaphragm's " + std::to_string(count) +
                                " points is expected");
  for (const int each : part.getValue()) rest.part.push_back(static_cast<DiaphragmPart>(each));
  rest.s = s.getValue();
  return rest;
}

const Sides& DiaphragmContacts::sides() {
  if (!sides_) {
    const Diaphragm rest = atRest();
    const auto half = [&](std::size_t number, Side side) {
      const PleuralWall& at = wall(number).wall();
      return Hemithorax{at, slideOf(at, rest, side, foldDrop.getValue())};
    };
    sides_ = Sides{half(0, Side::Left), half(1, Side::Right)};
  }
  return *sides_;
}

void DiaphragmContacts::bind() {
  sides_.reset();
  const DomeMotion dome{descent.getValue(), forward.getValue(), tilt.getValue(), foldDrop.getValue()};
  motion_.emplace(atRest(), sides(), dome);
}

void DiaphragmContacts::follow(std::span<Vec3f> all) {
  motion_->move(*sides_, {wallNow(0), wallNow(1)}, inflation.getValue(), all);
}

}  // namespace pleura
