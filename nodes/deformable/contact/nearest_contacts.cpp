#include <algorithm>
#include <cmath>
#include <numeric>

#include <pleura/nodes/deformable/contact/nearest_contacts.h>

namespace pleura {

namespace {

bool isWithin(const Eigen::Vector3f& p, const ContactRegion& region) {
  return p.array().isFinite().all() && p.z() >= region.leastZ && p.z() <= region.mostZ &&
         p.x() >= region.leastX;
}

}  // namespace

std::vector<Contact> nearestContacts(std::span<const Eigen::Vector3f> object1,
                                     std::span<const Eigen::Vector3f> object2, const ContactRegion& region,
                                     float reach) {
  std::vector<int> byX;
  for (int i = 0; i < static_cast<int>(object1.size()); ++i)
    if (object1[static_cast<std::size_t>(i)].array().isFinite().all()) byX.push_back(i);
  const auto x = [&](int i) { return object1[static_cast<std::size_t>(i)].x(); };
  std::stable_sort(byX.begin(), byX.end(), [&](int a, int b) { return x(a) < x(b); });

  std::vector<Contact> contacts;
  for (int second = 0; second < static_cast<int>(object2.size()); ++second) {
    const Eigen::Vector3f& b = object2[static_cast<std::size_t>(second)];
    if (!isWithin(b, region)) continue;
    Contact best{-1, second, reach};
    auto at = std::lower_bound(byX.begin(), byX.end(), b.x() - reach,
                               [&](int i, float limit) { return x(i) < limit; });
    for (; at != byX.end() && x(*at) <= b.x() + reach; ++at) {
      const float distance = (object1[static_cast<std::size_t>(*at)] - b).norm();
      const bool isNearer =
          distance < best.distance || (distance == best.distance && (best.first < 0 || *at < best.first));
      if (isNearer) best = {*at, second, distance};
    }
    if (best.first >= 0) contacts.push_back(best);
  }
  return contacts;
}

}  // namespace pleura
