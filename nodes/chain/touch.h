#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include <pleura/fields/joined_field.h>
#include <pleura/nodes/deformable/contact/nearest_contacts.h>

namespace pleura::chain {

/// The points of an object, routed from its Coordinate.point.
class RestCoord : public TypedField<MFVec3f, Types<MFVec3f>> {
 public:
  /// Where the points are at rest: of a Coordinate that an organ moves, the organ's origCoord.
  MFVec3f& rest();

 private:
  void update() override { value = rest().getValue(); }
};

class Touch;

/// Takes contacts, kept apart by the RotTransform they come from; as a value their pairs, one source after
/// the other.
class TouchInput : public MFInt32 {
 public:
  template <class Visit>
  void forEach(Visit visit) const {
    for (Field* input : routes_in)
      if (auto* touch = asTouch(input)) visit(*touch);
  }

 protected:
  void update() override;
  bool acceptsInput(const Field& from, std::size_t index, std::string& why) const override;

 private:
  static Touch* asTouch(Field* field);
};

/// Contacts between two objects at rest, found when somebody first asks and again when an input changes:
/// once, that is. As a value pairs, one after the other: the point of object 1 that is followed, the point of
/// object 2 that follows. A node to which contacts are routed finds none itself.
class Touch : public TouchInput {
 public:
  /// Which of the two distances of `dist` counts.
  explicit Touch(std::size_t distance = 0) : distance_(distance) {}

  /// Contacts and where their points of object 1 are at rest, one for each.
  struct Found {
    std::vector<Contact> contacts;
    std::vector<Vec3f> followed;
  };
  const Found& found() {
    upToDate();
    return found_;
  }

 private:
  void update() override;
  bool acceptsInput(const Field& from, std::size_t index, std::string& why) const override;
  void find(const std::vector<Vec3f>& object1, const std::vector<Vec3f>& object2);

  std::size_t distance_;
  std::array<std::uint64_t, 3> stamps_{};  // of the shapes and the limits that were compared
  Found found_;
};

}  // namespace pleura::chain
