#pragma once

#include <cstdint>
#include <vector>

namespace pleura {

/// Where a corner of a face takes its data from. What is not there has the number -1.
struct Corner {
  std::int32_t point = -1;
  std::int32_t normal = -1;
  std::int32_t color = -1;
};

/// Faces as runs of corners: face f has those from begin(f) up to end(f).
struct FaceList {
  std::vector<Corner> corners;
  std::vector<std::uint32_t> ends;

  std::size_t size() const { return ends.size(); }
  std::uint32_t begin(std::size_t face) const { return face == 0 ? 0 : ends[face - 1]; }
  std::uint32_t end(std::size_t face) const { return ends[face]; }

  void add(const Corner& corner) { corners.push_back(corner); }
  /// The corners added since the last call are a face; none: no face.
  void endFace() {
    if (end() != corners.size()) ends.push_back(static_cast<std::uint32_t>(corners.size()));
  }
  void addTriangle(const Corner& a, const Corner& b, const Corner& c) {
    corners.insert(corners.end(), {a, b, c});
    endFace();
  }

  /// The lines along each face's corners, as pairs of corners; it is not closed.
  std::vector<std::uint32_t> segments() const;

  /// Leaves out the faces that have a corner whose point is not among `pointCount`, and says how many.
  std::size_t dropFacesWithoutPoints(std::size_t pointCount);

 private:
  std::uint32_t end() const { return ends.empty() ? 0 : ends.back(); }
};

}  // namespace pleura
