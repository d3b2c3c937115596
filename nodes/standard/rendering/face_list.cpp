#include <algorithm>

#include <pleura/nodes/standard/rendering/face_list.h>

namespace pleura {

std::size_t FaceList::dropFacesWithoutPoints(std::size_t pointCount) {
  FaceList kept;
  kept.corners.reserve(corners.size());
  kept.ends.reserve(ends.size());
  for (std::size_t face = 0; face < size(); ++face) {
    const auto first = corners.begin() + begin(face);
    const auto last = corners.begin() + end(face);
    const bool isWhole = std::all_of(first, last, [&](const Corner& corner) {
      return corner.point >= 0 && static_cast<std::size_t>(corner.point) < pointCount;
    });
    if (!isWhole) continue;
    kept.corners.insert(kept.corners.end(), first, last);
    kept.endFace();
  }
  const std::size_t dropped = size() - kept.size();
  *this = std::move(kept);
  return dropped;
}

std::vector<std::uint32_t> FaceList::segments() const {
  std::vector<std::uint32_t> pairs;
  for (std::size_t face = 0; face < size(); ++face)
    for (std::uint32_t corner = begin(face) + 1; corner < end(face); ++corner)
      pairs.insert(pairs.end(), {corner - 1, corner});
  return pairs;
}

}  // namespace pleura
