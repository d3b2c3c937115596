#include <algorithm>
#include <atomic>
#include <bit>
#include <numeric>
#include <stdexcept>
#include <string>
#include <utility>

#include <Eigen/Geometry>

#include <pleura/haptics/contact/touch_mesh.h>

namespace pleura::haptics {

using Eigen::Vector3f;
using Eigen::Vector3i;

namespace {

std::uint64_t nextSerial() {
  static std::atomic<std::uint64_t> last{0};
  return ++last;
}

/// Told by the exponent's bits, since a comparison may trap.
bool isFinite(const Vector3f& p) {
  constexpr std::uint32_t exponent = 0x7f800000;
  return std::all_of(p.begin(), p.end(),
                     [](float x) { return (std::bit_cast<std::uint32_t>(x) & exponent) != exponent; });
}

void requireFinite(std::span<const Vector3f> points) {
  const auto bad = std::ranges::find_if_not(points, isFinite);
  if (bad != points.end())
    throw std::invalid_argument("points: point " + std::to_string(bad - points.begin()) + " is not finite");
}

bool hasArea(std::span<const Vector3f> points, const Vector3i& t) {
  const Eigen::Vector3d a = points[t[0]].cast<double>();
  const Eigen::Vector3d b = points[t[1]].cast<double>(), c = points[t[2]].cast<double>();
  return (b - a).cross(c - a).squaredNorm() > 0;
}

}  // namespace

TouchMesh::TouchMesh(std::span<const Vector3f> points, std::span<const Vector3i> triangles)
    : triangles_(triangles.begin(), triangles.end()), serial_(nextSerial()) {
  requireFinite(points);
  const int count = static_cast<int>(points.size());
  for (const Vector3i& t : triangles)
    if (t.minCoeff() < 0 || t.maxCoeff() >= count)
      throw std::invalid_argument("triangles: an index is out of the range of " + std::to_string(count) +
                                  " points");
  for (std::size_t t = 0; t < triangles.size(); ++t)
    if (hasArea(points, triangles[t])) ordered_.push_back(static_cast<int>(t));
  if (ordered_.empty())
    throw std::invalid_argument("triangles: a surface needs at least one that has an area");
  weld(points);
  findIncident();
  closed_ = everyEdgeHasTwoSides();
  std::vector<Vector3f> centroids;
  centroids.reserve(triangles.size());
  for (const Vector3i& t : triangles)
    centroids.push_back(points[t[0]] / 3 + points[t[1]] / 3 + points[t[2]] / 3);
  build(centroids, 0, static_cast<int>(ordered_.size()));
}

std::span<const int> TouchMesh::incident(int point) const {
  const int w = welded_[point];
  return std::span(incident_).subspan(incidentBegin_[w], incidentBegin_[w + 1] - incidentBegin_[w]);
}

void TouchMesh::weld(std::span<const Vector3f> points) {
  std::vector<int> byPlace(points.size());
  std::iota(byPlace.begin(), byPlace.end(), 0);
  const auto key = [&points](int i) { return std::tuple(points[i][0], points[i][1], points[i][2]); };
  std::ranges::sort(byPlace, [&key](int i, int j) { return std::pair(key(i), i) < std::pair(key(j), j); });
  welded_.resize(points.size());
  for (std::size_t k = 0; k < byPlace.size(); ++k) {
    const bool same = k > 0 && key(byPlace[k]) == key(byPlace[k - 1]);
    welded_[byPlace[k]] = same ? welded_[byPlace[k - 1]] : byPlace[k];
  }
}

void TouchMesh::findIncident() {
  incidentBegin_.assign(welded_.size() + 1, 0);
  for (const int t : ordered_)
    for (const int corner : triangles_[t]) ++incidentBegin_[welded_[corner] + 1];
  std::partial_sum(incidentBegin_.begin(), incidentBegin_.end(), incidentBegin_.begin());
  incident_.resize(incidentBegin_.back());
  std::vector<int> next(incidentBegin_.begin(), incidentBegin_.end() - 1);
  for (const int t : ordered_)
    for (const int corner : triangles_[t]) incident_[next[welded_[corner]]++] = t;
}

bool TouchMesh::everyEdgeHasTwoSides() const {
  std::vector<std::pair<int, int>> edges;
  edges.reserve(3 * ordered_.size());
  for (const int t : ordered_)
    for (int k = 0; k < 3; ++k)
      edges.emplace_back(welded_[triangles_[t][k]], welded_[triangles_[t][(k + 1) % 3]]);
  std::ranges::sort(edges);
  return std::ranges::all_of(edges, [&edges](const auto& edge) {
    return std::ranges::binary_search(edges, std::pair(edge.second, edge.first));
  });
}

/// Divides the range at the median of its longest axis; returns where the second half begins.
int TouchMesh::split(std::span<const Vector3f> centroids, int begin, int end) {
  Eigen::AlignedBox3f box;
  for (int i = begin; i < end; ++i) box.extend(centroids[ordered_[i]]);
  int axis = 0;
  box.sizes().maxCoeff(&axis);
  const int middle = begin + (end - begin) / 2;
  std::nth_element(ordered_.begin() + begin, ordered_.begin() + middle, ordered_.begin() + end,
                   [&centroids, axis](int s, int t) {
                     return std::pair(centroids[s][axis], s) < std::pair(centroids[t][axis], t);
                   });
  return middle;
}

TouchMesh::Child TouchMesh::build(std::span<const Vector3f> centroids, int begin, int end) {
  if (end - begin <= kLeafSize && !nodes_.empty()) return {begin, end - begin};
  const int self = static_cast<int>(nodes_.size());
  nodes_.emplace_back();
  const int middle = split(centroids, begin, end);
  for (const auto& [from, to] : {std::pair(begin, middle), std::pair(middle, end)}) {
    if (from == to) continue;
    const int half = to - from > kLeafSize ? split(centroids, from, to) : to;
    for (const auto& [first, last] : {std::pair(from, half), std::pair(half, to)}) {
      if (first == last) continue;
      const Child child = build(centroids, first, last);
      nodes_[self].children[nodes_[self].childCount++] = child;
    }
  }
  return {self, 0};
}

void TouchMeshFrame::fit(const TouchMesh& mesh, std::span<const Vector3f> moved) {
  if (moved.size() != mesh.pointCount())
    throw std::invalid_argument("points: " + std::to_string(moved.size()) + " for a surface of " +
                                std::to_string(mesh.pointCount()));
  requireFinite(moved);
  points.assign(moved.begin(), moved.end());
  boxes.resize(mesh.nodes().size());
  const std::span<const Vector3i> triangles = mesh.triangles();
  const std::span<const int> ordered = mesh.ordered();
  for (std::size_t i = mesh.nodes().size(); i-- > 0;) {
    const TouchMesh::Node& node = mesh.nodes()[i];
    TouchBoxes& own = boxes[i];
    for (int k = 0; k < node.childCount; ++k) {
      const auto [first, count] = node.children[k];
      if (count == 0) {
        own.low.row(k) = boxes[first].low.colwise().minCoeff();
        own.high.row(k) = boxes[first].high.colwise().maxCoeff();
        continue;
      }
      Eigen::AlignedBox3f box;
      for (int t = first; t < first + count; ++t)
        for (const int corner : triangles[ordered[t]]) box.extend(points[corner]);
      own.low.row(k) = box.min().transpose().array();
      own.high.row(k) = box.max().transpose().array();
    }
    for (int k = node.childCount; k < 4; ++k) {
      own.low.row(k) = own.low.row(0);
      own.high.row(k) = own.high.row(0);
    }
  }
  serial = nextSerial();
}

}  // namespace pleura::haptics
