#include <algorithm>
#include <tuple>

#include <fmt/format.h>

#include <pleura/nodes/chain/deformable_shape2.h>
#include <pleura/nodes/core/scene_context.h>
#include <pleura/nodes/thorax/rot_transform.h>

namespace pleura::chain {

void DeformableShape2::declare(NodeType& type) {
  pleura::DeformableShape2::declare(type);
  using enum Access;
  type.field<&DeformableShape2::points_to_follow>("points_to_follow", inputOutput, {})
      .measuredIn(Unit::length)
      .means("where the points are now that points of this organ follow, from each rib or organ");
  type.field<&DeformableShape2::touch_point_to_update>("touch_point_to_update", inputOutput, {})
      .means("pairs: the point followed, the point of this organ; from each contact node");
  type.field<&DeformableShape2::touch_rigid_points>("touch_rigid_points", inputOutput, {})
      .means("pairs: whose second points are rigid, with rigid_points; from each contact node");
  type.field<&DeformableShape2::coord>("coord", inputOutput, {})
      .means("pairs: whose first are points of this organ that another follows by coord_to_lung");
  type.field<&DeformableShape2::coord2>("coord2", inputOutput, {}).means("the same for coord_to_lung2");
  type.field<&DeformableShape2::coord_to_lung>("coord_to_lung", outputOnly, {})
      .measuredIn(Unit::length)
      .means("where the points named by coord are now");
  type.field<&DeformableShape2::coord_to_lung2>("coord_to_lung2", outputOnly, {})
      .measuredIn(Unit::length)
      .means("where the points named by coord2 are now");
  type.field<&DeformableShape2::dome>("dome", inputOutput, {}).means("points moved by domeTravel");
  type.field<&DeformableShape2::domeTravel>("domeTravel", inputOutput, Vec3f::Zero())
      .measuredIn(Unit::length)
      .means("way of the points of dome at inflation 1");
  type.field<&DeformableShape2::inflation>("inflation", inputOutput, 0)
      .means("0 at FRC, 1 at TLC: a sine of `frequency` over the time routed here, as RotTransform.rota");
  type.field<&DeformableShape2::frequency>("frequency", inputOutput, 0.25f)
      .measuredIn(Unit::frequency)
      .means("breaths a second");
  type.field<&DeformableShape2::keyboard>("keyboard", inputOnly, 0)
      .means("a key, from KeySensor.actionKeyPress or keyPress: pauses, or resumes");
  type.field<&DeformableShape2::pause_time>("pause_time", outputOnly, 0)
      .measuredIn(Unit::time)
      .means("when a key paused last");
  type.field<&DeformableShape2::resume_time>("resume_time", outputOnly, 0)
      .measuredIn(Unit::time)
      .means("when a key resumed last");
}

void DeformableShape2::onInitialize() {
  pleura::DeformableShape2::onInitialize();
  for (Field* input : std::initializer_list<Field*>{&points_to_follow, &touch_point_to_update,
                                                    &touch_rigid_points, &dome, &domeTravel, &inflation})
    input->routeNoEvent(deformedCoord, id);
  for (auto [points, contacts] : {std::pair(&coord_to_lung, &coord), std::pair(&coord_to_lung2, &coord2)}) {
    deformedCoord.routeNoEvent(*points, id);
    contacts->routeNoEvent(*points, id);
  }
  onKey_.hears(*this, keyboard);
}

TouchInput* DeformableShape2::contactsOf(const Field& field) {
  if (&field == &coord_to_lung) return &coord;
  return &field == &coord_to_lung2 ? &coord2 : nullptr;
}

namespace {

/// The contacts whose points a field holds; null when it holds none.
TouchInput* contactsIn(const Field& points) {
  auto* leader = dynamic_cast<Leader*>(points.getOwner());
  return leader != nullptr ? leader->contactsOf(points) : nullptr;
}

}  // namespace

void DeformableShape2::gatherContacts() {
  followers_.clear();
  points_to_follow.upToDate();
  touch_point_to_update.upToDate();
  for (Field* points : points_to_follow.getRoutesIn()) {
    if (auto* contacts = contactsIn(*points)) {
      gatherFollowers(*points, *contacts);
    } else {
      context().warn(*this, fmt::format("points_to_follow: {} is no rib_points or coord_to_lung",
                                        points->getFullName()));
    }
  }
  tellUnled();
  // The nearest comes last, and counts.
  std::sort(followers_.begin(), followers_.end(), [](const Follower& a, const Follower& b) {
    const auto key = [](const Follower& f) {
      return std::tuple(f.distance, f.leader.x(), f.leader.y(), f.leader.z());
    };
    return key(a) > key(b);
  });
  for (const auto& follower : followers_) drive(follower.point, follower.target);
  moveDome();
  pleura::DeformableShape2::gatherContacts();
}

void DeformableShape2::tellUnled() {
  touch_point_to_update.forEach([&](Touch& touch) {
    const auto& sources = points_to_follow.getRoutesIn();
    const bool isLed = std::any_of(sources.begin(), sources.end(), [&](const Field* points) {
      const auto* contacts = contactsIn(*points);
      return contacts != nullptr && touch.routesTo(contacts);
    });
    if (!isLed)
      context().warn(*this, fmt::format("touch_point_to_update: nothing in points_to_follow is moved by {}",
                                        touch.getFullName()));
  });
}

void DeformableShape2::moveDome() {
  const Vec3f way = inflation.getValue() * domeTravel.getValue();
  const auto& rest = origCoord.getValue();
  for (const int point : dome.getValue()) {
    if (point >= 0 && point < std::ssize(rest)) {
      drive(point, rest[static_cast<std::size_t>(point)] + way);
    } else {
      context().warn(*this, fmt::format("dome: there is no point {} among {}", point, rest.size()));
    }
  }
}

void DeformableShape2::gatherFollowers(Field& points, TouchInput& contacts) {
  const auto& now = static_cast<MFVec3f&>(points).getValue();
  const auto& rest = origCoord.getValue();
  std::size_t at = 0;
  contacts.forEach([&](Touch& touch) {
    const auto& found = touch.found();
    const bool isMine = touch.routesTo(touch_point_to_update);
    for (std::size_t k = 0; k < found.contacts.size(); ++k, ++at) {
      const auto& [first, second, distance] = found.contacts[k];
      if (!isMine || at >= now.size() || second >= std::ssize(rest)) continue;
      const Vec3f offset = now[at] - found.followed[k];
      followers_.push_back(
          {second, distance, found.followed[k], rest[static_cast<std::size_t>(second)] + offset});
    }
  });
}

const std::vector<int>& DeformableShape2::rigidPoints() {
  rigid_ = rigid_points.getValue();
  touch_rigid_points.upToDate();
  touch_rigid_points.forEach([&](Touch& touch) {
    for (const auto& contact : touch.found().contacts) rigid_.push_back(contact.second);
  });
  std::sort(rigid_.begin(), rigid_.end());
  rigid_.erase(std::unique(rigid_.begin(), rigid_.end()), rigid_.end());
  return rigid_;
}

void DeformableShape2::Followed::update() {
  value.clear();
  const auto& now = static_cast<MFVec3f*>(routes_in[0])->getValue();
  auto& contacts = static_cast<TouchInput&>(*routes_in[1]);
  contacts.upToDate();
  contacts.forEach([&](Touch& touch) {
    for (const auto& contact : touch.found().contacts)
      if (contact.first < std::ssize(now)) value.push_back(now[static_cast<std::size_t>(contact.first)]);
  });
}

void DeformableShape2::Inflation::update() {
  auto& node = static_cast<DeformableShape2&>(*getOwner());
  value = static_cast<float>(sineInflation(static_cast<SFTime&>(*routes_in[0]), node.frequency.getValue()));
}

void DeformableShape2::Keyboard::update() {
  event.sender->upToDate();
  auto* action = dynamic_cast<SFInt32*>(event.sender);
  value = action != nullptr ? action->getValue() : 0;
}

void DeformableShape2::onKey() {
  constexpr Time kLater = 1e-6;  // a TimeSensor tells a pause from a resumption by which is later
  const Time now = context().time.getValue();
  isPaused_ = !isPaused_;
  SFTime& sent = isPaused_ ? pause_time : resume_time;
  SFTime& before = isPaused_ ? resume_time : pause_time;
  sent.setValue(std::max(now, before.getValue() + kLater), id);
}

}  // namespace pleura::chain
