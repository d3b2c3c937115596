#pragma once

#include <optional>

#include <pleura/nodes/thorax/contacts_node.h>
#include <pleura/nodes/thorax/motion/diaphragm_motion.h>
#include <pleura/nodes/thorax/pleural_wall_node.h>

namespace pleura {

/// Holds the diaphragm: its rim and zone of apposition to the walls, its central tendon to a piston that
/// descends as the chest inflates.
class DiaphragmContacts : public ContactsNode {
 public:
  MFNode walls;
  MFInt32 part;
  MFFloat s;
  SFFloat descent;
  SFFloat forward;
  SFFloat tilt;
  SFFloat foldDrop;

  class DomeHeight : public TypedField<SFFloat, Types<MFVec3f>> {
    void update() override;
  };
  DomeHeight domeHeight;

  /// The walls with the lines on them between which lung and diaphragm slide: left, right. Throws
  /// std::invalid_argument.
  const Sides& sides();
  std::span<const Vec4f> wallNow(std::size_t side) { return wall(side).now(); }

  static void declare(NodeType& type);

 protected:
  void onInitialize() override;
  void bind() override;
  void follow(std::span<Vec3f> all) override;
  std::span<const int> driven() const override { return motion_->driven(); }
  std::vector<Field*> movers() override;

 private:
  PleuralWallNode& wall(std::size_t side);
  Diaphragm atRest();

  std::optional<Sides> sides_;
  std::optional<DiaphragmMotion> motion_;
};

}  // namespace pleura
