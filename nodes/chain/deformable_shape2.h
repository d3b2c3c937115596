#pragma once

#include <array>
#include <vector>

#include <pleura/nodes/chain/leader.h>
#include <pleura/nodes/core/event_handler.h>
#include <pleura/nodes/thorax/deformable_shape2.h>

namespace pleura::chain {

/// DeformableShape2 as the thesis wires it (Jacob 2008): its points follow the points that others name for
/// them in `points_to_follow`, by the contacts in `touch_point_to_update`. A point keeps its offset at rest
/// from the one it follows; of several, the nearest at rest. Nothing depends on the order of routes.
class DeformableShape2 : public pleura::DeformableShape2, public Leader {
 public:
  JoinedField<MFVec3f> points_to_follow;
  TouchInput touch_point_to_update;
  TouchInput touch_rigid_points;

  TouchInput coord;
  TouchInput coord2;
  /// Where the points are now that the contacts in `coord`, or `coord2`, name.
  class Followed : public TypedField<MFVec3f, Types<MFVec3f, MFInt32>> {
    void update() override;
  };
  Followed coord_to_lung;
  Followed coord_to_lung2;

  MFInt32 dome;
  SFVec3f domeTravel;
  class Inflation : public TypedField<SFFloat, Types<SFTime>> {
    void update() override;
  };
  Inflation inflation;
  SFFloat frequency;

  class Keyboard : public TypedField<SFInt32, AnyNumber<Any<SFInt32, SFString>>> {
    void update() override;
  };
  Keyboard keyboard;
  SFTime pause_time;
  SFTime resume_time;

  TouchInput* contactsOf(const Field& field) override;
  static void declare(NodeType& type);

 protected:
  void onInitialize() override;
  void gatherContacts() override;
  const std::vector<int>& rigidPoints() override;

 private:
  /// A point of the organ that follows another.
  struct Follower {
    int point;
    float distance;  // at rest
    Vec3f leader;    // at rest
    Vec3f target;
  };
  void gatherFollowers(Field& points, TouchInput& contacts);
  /// Warns of contacts that name followers, but nobody whom they follow.
  void tellUnled();
  void moveDome();
  void onKey();

  std::vector<Follower> followers_;
  std::vector<int> rigid_;
  bool isPaused_ = false;
  EventHandler onKey_{[this] { onKey(); }};
};

}  // namespace pleura::chain
