#pragma once

#include <optional>

#include <pleura/nodes/thorax/contacts_node.h>
#include <pleura/nodes/thorax/diaphragm_contacts.h>
#include <pleura/nodes/thorax/motion/lung_motion.h>

namespace pleura {

/// Holds a lung: its costal surface slides on the wall, its base rests on the diaphragm.
class LungContacts : public ContactsNode {
 public:
  SFFloat side;
  TypedSFNode<DiaphragmContacts> diaphragm;
  MFInt32 part;

  static void declare(NodeType& type);

 protected:
  void bind() override;
  void follow(std::span<Vec3f> all) override;
  std::span<const int> driven() const override { return motion_->driven(); }
  std::vector<Field*> movers() override;

 private:
  std::size_t sideNumber() { return side.getValue() < 0 ? 1 : 0; }

  std::optional<LungMotion> motion_;
};

}  // namespace pleura
