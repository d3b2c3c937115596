#include <algorithm>
#include <set>
#include <utility>

#include <pleura/nodes/thorax/anatomy/open_sheet.h>

namespace pleura {
namespace {

using Eigen::Vector3f;
using Eigen::Vector3i;

std::set<std::pair<int, int>> halfEdges(const std::vector<Vector3i>& triangles) {
  std::set<std::pair<int, int>> edges;
  for (const Vector3i& t : triangles) {
    for (int k = 0; k < 3; ++k) edges.emplace(t[k], t[(k + 1) % 3]);
  }
  return edges;
}

// Each removal may leave new ones.
void removeEars(std::vector<Vector3i>& triangles) {
  for (std::size_t before = triangles.size() + 1; triangles.size() < before;) {
    before = triangles.size();
    const auto edges = halfEdges(triangles);
    std::erase_if(triangles, [&](const Vector3i& t) {
      int open = 0;
      for (int k = 0; k < 3; ++k) open += !edges.contains({t[(k + 1) % 3], t[k]});
      return open >= 2;
    });
  }
}

void removeUnusedPoints(TriangleMesh& mesh) {
  std::vector<int> place(mesh.points.size(), -1);
  std::vector<Vector3f> used;
  for (Vector3i& t : mesh.triangles) {
    for (int& corner : t) {
      if (place[corner] < 0) {
        place[corner] = static_cast<int>(used.size());
        used.push_back(mesh.points[corner]);
      }
      corner = place[corner];
    }
  }
  mesh.points = std::move(used);
}

}  // namespace

OpenSheet cutOpen(const TriangleMesh& closed, const std::vector<bool>& keep) {
  OpenSheet sheet;
  sheet.mesh.points = closed.points;
  for (const Vector3i& t : closed.triangles) {
    if (keep[t[0]] && keep[t[1]] && keep[t[2]]) sheet.mesh.triangles.push_back(t);
  }
  removeEars(sheet.mesh.triangles);
  removeUnusedPoints(sheet.mesh);
  sheet.next.assign(sheet.mesh.points.size(), -1);
  const auto edges = halfEdges(sheet.mesh.triangles);
  for (const auto& [a, b] : edges) {
    if (!edges.contains({b, a})) sheet.next[a] = b;
  }
  return sheet;
}

Vector3f nearestOnLoop(const std::vector<Vector3f>& loop, const Vector3f& point) {
  Vector3f best = loop.front();
  for (std::size_t k = 0; k < loop.size(); ++k) {
    const Vector3f axis = loop[(k + 1) % loop.size()] - loop[k];
    const float t = std::clamp((point - loop[k]).dot(axis) / axis.squaredNorm(), 0.0f, 1.0f);
    const Vector3f candidate = loop[k] + t * axis;
    if ((candidate - point).squaredNorm() < (best - point).squaredNorm()) best = candidate;
  }
  return best;
}

}  // namespace pleura
