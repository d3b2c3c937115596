#include <algorithm>
#include <atomic>
#include <bit>
#include <iterator>
#include <numeric>
#include <stdexcept>
#include <string>
#include <utility>

#include <Eigen/Geometry>

#include <pleura/haptics/contact/touch_mesh.h>

namespace pleura::haptics {

using Eigen::Array4f;
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

/// Divides the range at the median of its longest axis; returns where the second half begins.
int split(std::span<const Vector3f> centroids, std::span<int> order, int begin, int end) {
  Eigen::AlignedBox3f box;
  for (int i = begin; i < end; ++i) box.extend(centroids[order[i]]);
  int axis = 0;
  box.sizes().maxCoeff(&axis);
  const int middle = begin + (end - begin) / 2;
  std::nth_element(order.begin() + begin, order.begin() + middle, order.begin() + end,
                   [&centroids, axis](int s, int t) {
                     return std::pair(centroids[s][axis], s) < std::pair(centroids[t][axis], t);
                   });
  return middle;
}

}  // namespace

TouchMesh::TouchMesh(std::span<const Vector3f> points, std::span<const Vector3i> triangles)
    : serial_(nextSerial()) {
  requireFinite(points);
  const int count = static_cast<int>(points.size());
  for (const Vector3i& t : triangles)
    if (t.minCoeff() < 0 || t.maxCoeff() >= count)
      throw std::invalid_argument("triangles: an index is out of the range of " + std::to_string(count) +
                                  " points");
  std::ranges::copy_if(triangles, std::back_inserter(triangles_),
                       [&points](const Vector3i& t) { return hasArea(points, t); });
  if (triangles_.empty())
    throw std::invalid_argument("triangles: a surface needs at least one that has an area");
  sortIntoTree(points);
  weld(points);
  findIncident();
  closed_ = everyEdgeHasTwoSides();
}

void TouchMesh::sortIntoTree(std::span<const Vector3f> points) {
  std::vector<Vector3f> centroids;
  centroids.reserve(triangles_.size());
  for (const Vector3i& t : triangles_)
    centroids.push_back(points[t[0]] / 3 + points[t[1]] / 3 + points[t[2]] / 3);
  std::vector<int> order(triangles_.size());
  std::iota(order.begin(), order.end(), 0);
  build(centroids, order, 0, static_cast<int>(order.size()));
  const std::vector<Vector3i> unsorted = triangles_;
  std::ranges::transform(order, triangles_.begin(), [&unsorted](int t) { return unsorted[t]; });
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
  for (const Vector3i& t : triangles_)
    for (const int corner : t) ++incidentBegin_[welded_[corner] + 1];
  std::partial_sum(incidentBegin_.begin(), incidentBegin_.end(), incidentBegin_.begin());
  incident_.resize(incidentBegin_.back());
  std::vector<int> next(incidentBegin_.begin(), incidentBegin_.end() - 1);
  for (int t = 0; t < static_cast<int>(triangles_.size()); ++t)
    for (const int corner : triangles_[t]) incident_[next[welded_[corner]]++] = t;
}

bool TouchMesh::everyEdgeHasTwoSides() const {
  std::vector<std::pair<int, int>> edges;
  edges.reserve(3 * triangles_.size());
  for (const Vector3i& t : triangles_)
    for (int k = 0; k < 3; ++k) edges.emplace_back(welded_[t[k]], welded_[t[(k + 1) % 3]]);
  std::ranges::sort(edges);
  return std::ranges::all_of(edges, [&edges](const auto& edge) {
    return std::ranges::binary_search(edges, std::pair(edge.second, edge.first));
  });
}

TouchMesh::Child TouchMesh::build(std::span<const Vector3f> centroids, std::span<int> order, int begin,
                                  int end) {
  if (end - begin <= kLeafSize && !nodes_.empty()) return {begin, end - begin};
  const int self = static_cast<int>(nodes_.size());
  nodes_.emplace_back();
  const int middle = split(centroids, order, begin, end);
  for (const auto& [from, to] : {std::pair(begin, middle), std::pair(middle, end)}) {
    if (from == to) continue;
    const int half = to - from > kLeafSize ? split(centroids, order, from, to) : to;
    for (const auto& [first, last] : {std::pair(from, half), std::pair(half, to)}) {
      if (first == last) continue;
      const Child child = build(centroids, order, first, last);
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
  points.resize(moved.size());
  std::ranges::transform(moved, points.begin(),
                         [](const Vector3f& p) { return Array4f(p[0], p[1], p[2], 0); });
  boxes.resize(mesh.nodes().size());
  const std::span<const Vector3i> triangles = mesh.triangles();
  for (std::size_t i = mesh.nodes().size(); i-- > 0;) {
    const TouchMesh::Node& node = mesh.nodes()[i];
    FourBoxes& own = boxes[i];
    for (int k = 0; k < node.childCount; ++k) {
      const auto [first, count] = node.children[k];
      if (count == 0) {
        own.enclose(k, boxes[first]);
        continue;
      }
      Array4f low = points[triangles[first][0]], high = low;
      for (int t = first; t < first + count; ++t)
        for (const int corner : triangles[t]) {
          low = low.min(points[corner]);
          high = high.max(points[corner]);
        }
      own.low.row(k) = low.head<3>().transpose();
      own.high.row(k) = high.head<3>().transpose();
    }
    for (int k = node.childCount; k < 4; ++k) {
      own.low.row(k) = own.low.row(0);
      own.high.row(k) = own.high.row(0);
    }
  }
  serial = nextSerial();
}

}  // namespace pleura::haptics
