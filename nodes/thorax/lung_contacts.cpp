#include <stdexcept>

#include <pleura/nodes/thorax/lung_contacts.h>

namespace pleura {

void LungContacts::declare(NodeType& type) {
  ContactsNode::declare(type);
  type.named("LungContacts", "Pleura")
      .means("holds a lung: it slides on the wall and rests on the diaphragm");
  using enum Access;
  type.field<&LungContacts::side>("side", initializeOnly, 1).within(-1, 1).means("1 left, -1 right");
  type.field<&LungContacts::diaphragm>("diaphragm", initializeOnly, {})
      .means("the DiaphragmContacts of the diaphragm below, which knows the walls");
  type.field<&LungContacts::part>("part", initializeOnly, {})
      .within(0, 2)
      .means("of each point: 0 costal, 1 diaphragmatic, 2 mediastinal");
}

std::vector<Field*> LungContacts::movers() {
  auto* below = diaphragm.get();
  if (below == nullptr || below->organ.get() == nullptr) return {};
  std::vector<Field*> fields{&below->organ.get()->deformedCoord};
  for (const auto& each : below->walls.getValue())
    if (auto* node = dynamic_cast<PleuralWallNode*>(each.get())) fields.push_back(&node->points);
  return fields;
}

void LungContacts::bind() {
  auto* below = diaphragm.get();
  if (below == nullptr || below->organ.get() == nullptr)
    throw std::invalid_argument("diaphragm: a DiaphragmContacts with an organ is expected");
  Lung rest;
  rest.side = side.getValue() < 0 ? Side::Right : Side::Left;
  rest.mesh = organ.get()->rest();
  if (part.size() != rest.mesh.points.size())
    throw std::invalid_argument("part: one value for each of the lung's " +
                                std::to_string(rest.mesh.points.size()) + " points is expected");
  for (const int each : part.getValue()) rest.part.push_back(static_cast<LungPart>(each));
  motion_.emplace(rest, below->sides()[sideNumber()], below->organ.get()->rest());
}

void LungContacts::follow(std::span<Vec3f> all) {
  auto& below = *diaphragm.get();
  motion_->move(below.sides()[sideNumber()], below.wallNow(sideNumber()),
                below.organ.get()->deformedCoord.getValue(), inflation.getValue(), all);
}

}  // namespace pleura
