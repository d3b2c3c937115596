#include <algorithm>
#include <limits>
#include <queue>
#include <stdexcept>
#include <utility>

#include <pleura/nodes/deformable/mesh/components.h>
#include <pleura/nodes/deformable/mesh/nearest_point.h>
#include <pleura/nodes/deformable/mesh/repair.h>
#include <pleura/nodes/deformable/mesh/topology.h>
#include <pleura/nodes/thorax/anatomy/bone_lines.h>
#include <pleura/nodes/thorax/anatomy/inner_line.h>
#include <pleura/nodes/thorax/anatomy/spline.h>

namespace pleura {
namespace {

using Eigen::Vector3d;
using Eigen::Vector3f;

// Distances along the edges from one point (Dijkstra 1959).
std::vector<float> distancesFrom(int start, const TriangleMesh& mesh, const Adjacency& around) {
  std::vector<float> distance(mesh.points.size(), std::numeric_limits<float>::max());
  std::priority_queue<std::pair<float, int>, std::vector<std::pair<float, int>>, std::greater<>> front;
  distance[start] = 0.0f;
  front.emplace(0.0f, start);
  while (!front.empty()) {
    const auto [d, i] = front.top();
    front.pop();
    if (d > distance[i]) continue;
    for (const int k : around[i]) {
      const float next = d + (mesh.points[k] - mesh.points[i]).norm();
      if (next >= distance[k]) continue;
      distance[k] = next;
      front.emplace(next, k);
    }
  }
  return distance;
}

int farthest(const std::vector<float>& distance) {
  return static_cast<int>(std::max_element(distance.begin(), distance.end()) - distance.begin());
}

// Without the first and the last slice, whose place the ends take.
std::vector<Vector3d> sliceMiddles(const TriangleMesh& mesh, const std::vector<float>& distance, int slices) {
  const float length = distance[farthest(distance)];
  std::vector<Vector3d> sum(slices, Vector3d::Zero());
  std::vector<int> count(slices, 0);
  for (std::size_t i = 0; i < mesh.points.size(); ++i) {
    const int slice =
        std::min(static_cast<int>(distance[i] / length * static_cast<float>(slices)), slices - 1);
    sum[slice] += mesh.points[i].cast<double>();
    ++count[slice];
  }
  std::vector<Vector3d> middles;
  for (int k = 1; k + 1 < slices; ++k) {
    if (count[k] > 0) middles.push_back(sum[k] / count[k]);
  }
  return middles;
}

std::vector<Vector3f> resampled(const std::vector<Vector3d>& line, int samples) {
  std::vector<double> knots{0.0};
  for (std::size_t k = 1; k < line.size(); ++k)
    knots.push_back(knots.back() + (line[k] - line[k - 1]).norm());
  const Spline spline(knots, line);
  const ArcLength way(spline);
  std::vector<Vector3f> points;
  points.reserve(static_cast<std::size_t>(samples));
  for (int k = 0; k < samples; ++k) {
    points.push_back(spline.at(way.parameter(way.length() * k / (samples - 1))).cast<float>());
  }
  return points;
}

std::vector<Vector3f> innerPoints(const TriangleMesh& mesh, const std::vector<Vector3f>& centreline,
                                  Side side) {
  std::vector<Vector3f> inner = centreline;
  std::vector<float> reach(centreline.size(), 0.0f);
  for (const Vector3f& point : mesh.points) {
    const std::size_t k = nearestPoint(centreline, point);
    const Vector3d towards = lungAxisNear(centreline[k].cast<double>(), side) - centreline[k].cast<double>();
    const float along = towards.normalized().cast<float>().dot(point - centreline[k]);
    if (along <= reach[k]) continue;
    reach[k] = along;
    inner[k] = point;
  }
  return inner;
}

}  // namespace

TriangleMesh largestPiece(const TriangleMesh& mesh) {
  const std::vector<Component> pieces = components(mesh.triangles);
  if (pieces.empty()) throw std::invalid_argument("largestPiece: mesh: no triangles");
  const auto largest = std::max_element(
      pieces.begin(), pieces.end(),
      [](const Component& a, const Component& b) { return a.triangles.size() < b.triangles.size(); });
  TriangleMesh piece{mesh.points, gather(mesh.triangles, largest->triangles)};
  removeUnreferencedPoints(piece);
  return piece;
}

BoneLines boneLines(const TriangleMesh& mesh, const Vector3f& start, Side side, int samples) {
  const Adjacency around = neighbours(mesh.points.size(), mesh.triangles);
  const int oneEnd = farthest(distancesFrom(0, mesh, around));
  const int otherEnd = farthest(distancesFrom(oneEnd, mesh, around));
  const bool oneIsStart = (mesh.points[oneEnd] - start).norm() < (mesh.points[otherEnd] - start).norm();
  const std::vector<float> distance = distancesFrom(oneIsStart ? oneEnd : otherEnd, mesh, around);
  std::vector<Vector3d> line = sliceMiddles(mesh, distance, samples);
  line.insert(line.begin(), mesh.points[oneIsStart ? oneEnd : otherEnd].cast<double>());
  line.push_back(mesh.points[farthest(distance)].cast<double>());
  BoneLines lines;
  lines.centreline = resampled(line, samples);
  lines.innerLine = innerPoints(mesh, lines.centreline, side);
  return lines;
}

}  // namespace pleura
