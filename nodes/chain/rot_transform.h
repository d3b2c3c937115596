#pragma once

#include <string>

#include <pleura/nodes/chain/leader.h>
#include <pleura/nodes/thorax/rot_transform.h>

namespace pleura::chain {

/// RotTransform as the thesis wires it (Jacob 2008), in two roles. A rib turns, and its `rib_points` are
/// where the points are now that the contacts routed to `touch` name. A contact node compares `coord1` with
/// `coord2` and tells the contacts by `touch` and `rigid_touch`; an event at its `rota` needs no answer: they
/// are found when somebody asks.
class RotTransform : public pleura::RotTransform, public Leader {
 public:
  RestCoord coord1;
  RestCoord coord2;
  MFFloat dist;
  Touch touch{0};
  Touch rigid_touch{1};

  TouchInput* contactsOf(const Field& field) override { return &field == &rib_points ? &touch : nullptr; }
  /// Tells the scene's author.
  void tell(const std::string& message);

  static void declare(NodeType& type);

 protected:
  void onInitialize() override;

 private:
  /// The rest places of this node's points that others follow.
  class Followed : public TypedField<MFVec3f, Types<MFInt32>> {
    void update() override;
  };
  Followed followed_;
};

}  // namespace pleura::chain
