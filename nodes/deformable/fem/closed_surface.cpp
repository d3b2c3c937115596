#include <algorithm>
#include <stdexcept>
#include <string>
#include <utility>

#include <pleura/nodes/deformable/fem/closed_surface.h>
#include <pleura/nodes/deformable/mesh/components.h>
#include <pleura/nodes/deformable/mesh/edge_uses.h>
#include <pleura/nodes/deformable/mesh/holes.h>
#include <pleura/nodes/deformable/mesh/measures.h>
#include <pleura/nodes/deformable/mesh/orientation.h>
#include <pleura/nodes/deformable/mesh/repair.h>
#include <pleura/nodes/deformable/mesh/topology.h>

namespace pleura {

namespace {

using Eigen::Vector3d;
using Eigen::Vector3f;
using Eigen::Vector3i;

bool isSound(std::span<const Vector3i> triangles) {
  bool sound = true;
  forEachEdge(edgeUses(triangles), [&sound](std::span<const EdgeUse> edge) { sound &= isOriented(edge); });
  return sound;
}

void turnAround(std::span<Vector3i> triangles) {
  for (Vector3i& triangle : triangles) std::swap(triangle[1], triangle[2]);
}

void requireMostlyClosed(const std::vector<std::vector<int>>& loops, const ClosedSurface& surface) {
  const std::size_t edges = (3 * surface.mesh.triangles.size() + surface.openEdges) / 2;
  if (4 * static_cast<std::size_t>(surface.openEdges) > edges)
    throw std::invalid_argument("triangles: no closed surface: " + std::to_string(surface.openEdges) +
                                " of " + std::to_string(edges) + " edges are open, around " +
                                std::to_string(loops.size()) + " holes");
}

void closeHoles(ClosedSurface& surface) {
  auto& [points, triangles] = surface.mesh;
  const std::vector<std::vector<int>> loops = boundaryLoops(surface.mesh);
  surface.holes = static_cast<int>(loops.size());
  for (const std::vector<int>& loop : loops) surface.openEdges += static_cast<int>(loop.size());
  requireMostlyClosed(loops, surface);
  for (const std::vector<int>& loop : loops) {
    Vector3d mean = Vector3d::Zero();
    for (const int point : loop) mean += points[point].cast<double>() / static_cast<double>(loop.size());
    const int apex = static_cast<int>(points.size());
    points.push_back(mean.cast<float>());
    for (std::size_t i = 0; i < loop.size(); ++i)
      triangles.emplace_back(loop[i], loop[(i + 1) % loop.size()], apex);
  }
}

/// Numbers the parts; whether one of them has a negative volume.
bool numberParts(ClosedSurface& surface) {
  const auto& [points, triangles] = surface.mesh;
  const std::vector<Component> parts = components(triangles);
  surface.partCount = static_cast<int>(parts.size());
  surface.parts.resize(triangles.size());
  bool hasInsideOut = false;
  for (int i = 0; i < surface.partCount; ++i) {
    for (const int t : parts[i].triangles) surface.parts[t] = i;
    hasInsideOut = hasInsideOut || signedVolume(points, gather(triangles, parts[i].triangles)) < 0;
  }
  return hasInsideOut;
}

}  // namespace

ClosedSurface closeSurface(std::span<const Vector3f> points, std::span<const Vector3i> triangles) {
  if (triangles.empty()) throw std::invalid_argument("triangles: there are none");
  if (triangles.size() > kMostSurfaceTriangles)
    throw std::invalid_argument("triangles: there are " + std::to_string(triangles.size()) + ", at most " +
                                std::to_string(kMostSurfaceTriangles) + " are taken");
  requireFinite(points);
  requireIndicesInRange(points.size(), triangles);
  ClosedSurface surface;
  surface.mesh = {{points.begin(), points.end()}, {triangles.begin(), triangles.end()}};
  auto& mesh = surface.mesh;
  // Before parts are turned one by one, or the cavities of a body that is inside out would be lost.
  surface.wasInsideOut = signedVolume(points, triangles) < 0;
  if (surface.wasInsideOut) turnAround(mesh.triangles);
  const bool sound = isSound(triangles);
  if (!sound) {
    const RepairReport done = repair(mesh, {.maxHoleEdges = 0});
    surface.droppedTriangles = done.droppedTriangles;
    surface.turnedTriangles = done.turnedTriangles;
    surface.turnedParts = done.turnedParts;
  }
  surface.lidsBegin = static_cast<int>(mesh.triangles.size());
  if (!sound) closeHoles(surface);
  if (numberParts(surface)) surface.turnedParts += faceOutwards(mesh.points, mesh.triangles);
  surface.volume = signedVolume(mesh.points, mesh.triangles);
  return surface;
}

}  // namespace pleura
