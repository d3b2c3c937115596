#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include <pleura/nodes/standard/rendering/smoothing_groups.h>
#include <pleura/nodes/standard/rendering/triangulation.h>

namespace pleura {

namespace {

/// Disjoint sets of corners, each known by its first.
class CornerSets {
 public:
  explicit CornerSets(std::size_t count) : parent_(count) { std::iota(parent_.begin(), parent_.end(), 0u); }

  std::uint32_t find(std::uint32_t corner) {
    while (parent_[corner] != corner) corner = parent_[corner] = parent_[parent_[corner]];
    return corner;
  }
  void join(std::uint32_t a, std::uint32_t b) {
    a = find(a);
    b = find(b);
    parent_[std::max(a, b)] = std::min(a, b);
  }

 private:
  std::vector<std::uint32_t> parent_;
};

/// An edge as its face sees it, its ends sorted by point.
struct Edge {
  std::int32_t low, high;               // points
  std::uint32_t lowCorner, highCorner;  // of the face at those
  std::uint32_t face;
};

std::vector<Edge> edgesOf(const FaceList& faces) {
  std::vector<Edge> edges;
  edges.reserve(faces.corners.size());
  for (std::uint32_t face = 0; face < faces.size(); ++face)
    for (auto from = faces.begin(face); from < faces.end(face); ++from) {
      const auto to = from + 1 < faces.end(face) ? from + 1 : faces.begin(face);
      const std::int32_t a = faces.corners[from].point;
      const std::int32_t b = faces.corners[to].point;
      edges.push_back(a < b ? Edge{a, b, from, to, face} : Edge{b, a, to, from, face});
    }
  std::stable_sort(edges.begin(), edges.end(), [](const Edge& x, const Edge& y) {
    return std::pair(x.low, x.high) < std::pair(y.low, y.high);
  });
  return edges;
}

bool isSmooth(const Vec3d& a, const Vec3d& b, double cosine) {
  return a.dot(b) > cosine * a.norm() * b.norm();
}

void joinSamePoints(const FaceList& faces, CornerSets& sets) {
  std::vector<std::uint32_t> corners(faces.corners.size());
  std::iota(corners.begin(), corners.end(), 0u);
  std::stable_sort(corners.begin(), corners.end(), [&](std::uint32_t x, std::uint32_t y) {
    return faces.corners[x].point < faces.corners[y].point;
  });
  for (std::size_t i = 1; i < corners.size(); ++i)
    if (faces.corners[corners[i]].point == faces.corners[corners[i - 1]].point)
      sets.join(corners[i - 1], corners[i]);
}

void joinAcrossEdges(const FaceList& faces, std::span<const Vec3f> points, double creaseAngle,
                     CornerSets& sets) {
  std::vector<Vec3d> normals;
  for (std::size_t face = 0; face < faces.size(); ++face) normals.push_back(areaVector(faces, face, points));
  const double cosine = std::cos(creaseAngle);
  const std::vector<Edge> edges = edgesOf(faces);
  for (std::size_t i = 0; i < edges.size(); ++i)
    for (std::size_t k = i + 1;
         k < edges.size() && edges[k].low == edges[i].low && edges[k].high == edges[i].high; ++k) {
      if (!isSmooth(normals[edges[i].face], normals[edges[k].face], cosine)) continue;
      sets.join(edges[i].lowCorner, edges[k].lowCorner);
      sets.join(edges[i].highCorner, edges[k].highCorner);
    }
}

}  // namespace

std::vector<std::uint32_t> smoothingGroups(const FaceList& faces, std::span<const Vec3f> points,
                                           double creaseAngle) {
  CornerSets sets(faces.corners.size());
  if (creaseAngle >= std::numbers::pi) {
    joinSamePoints(faces, sets);
  } else if (creaseAngle > 0) {
    joinAcrossEdges(faces, points, creaseAngle, sets);
  } else {
    for (std::size_t face = 0; face < faces.size(); ++face)
      for (auto corner = faces.begin(face) + 1; corner < faces.end(face); ++corner)
        sets.join(faces.begin(face), corner);
  }
  std::vector<std::uint32_t> groups(faces.corners.size());
  std::uint32_t count = 0;
  for (std::uint32_t corner = 0; corner < groups.size(); ++corner) {
    const std::uint32_t first = sets.find(corner);
    groups[corner] = first == corner ? count++ : groups[first];
  }
  return groups;
}

}  // namespace pleura
