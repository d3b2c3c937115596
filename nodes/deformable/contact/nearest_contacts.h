#pragma once

#include <span>
#include <vector>

#include <Eigen/Core>

namespace pleura {

/// Which points of object 2 are looked at (Jacob 2008): leastZ <= z <= mostZ and x >= leastX [m].
struct ContactRegion {
  float leastZ, mostZ, leastX;
};

/// A point of object 2 and its nearest of object 1, the lower index of two that are equally near.
struct Contact {
  int first;   // of object 1
  int second;  // of object 2
  float distance;
  bool operator==(const Contact&) const = default;
};

/// Every contact within `reach` [m], by ascending second index. Points that are not finite have none. n log
/// n, and linear in the pairs whose x differs by less than the reach.
std::vector<Contact> nearestContacts(std::span<const Eigen::Vector3f> object1,
                                     std::span<const Eigen::Vector3f> object2, const ContactRegion& region,
                                     float reach);

}  // namespace pleura
