#include <algorithm>
#include <map>

#include <pleura/nodes/deformable/mesh/components.h>
#include <pleura/nodes/deformable/mesh/disjoint_sets.h>
#include <pleura/nodes/deformable/mesh/edge_uses.h>
#include <pleura/nodes/deformable/mesh/measures.h>
#include <pleura/nodes/deformable/mesh/mesh_report.h>
#include <pleura/nodes/deformable/mesh/triangle_checks.h>
#include <pleura/nodes/deformable/mesh/weld.h>

namespace pleura {

namespace {

using Eigen::Vector3f;
using Eigen::Vector3i;

int count(const std::vector<bool>& flags) {
  return static_cast<int>(std::count(flags.begin(), flags.end(), true));
}

void lookAtPoints(const TriangleMesh& mesh, MeshReport& report) {
  report.points = static_cast<int>(mesh.points.size());
  for (const Vector3f& point : mesh.points) {
    if (isFinite(point))
      report.box.extend(point);
    else
      ++report.nonFinitePoints;
  }
  const std::vector<int> welded = weldedPoints(mesh.points, 0);
  for (int i = 0; i < report.points; ++i) report.duplicatePoints += welded[i] != i ? 1 : 0;
}

/// Counts the triangles that can't be worked with and returns the others.
std::vector<Vector3i> lookAtTriangles(const TriangleMesh& mesh, MeshReport& report) {
  report.triangles = static_cast<int>(mesh.triangles.size());
  std::vector<bool> unreferenced(mesh.points.size(), true);
  std::vector<Vector3i> sound;
  for (const Vector3i& triangle : mesh.triangles) {
    if (!isInRange(triangle, mesh.points.size())) {
      ++report.outOfRangeTriangles;
      continue;
    }
    for (const int corner : triangle) unreferenced[corner] = false;
    if (repeatsPoint(triangle))
      ++report.degenerateTriangles;
    else if (isFinite(triangle, mesh.points))
      sound.push_back(triangle);
  }
  report.unreferencedPoints = count(unreferenced);
  const Twins twin = twins(sound);
  report.duplicateTriangles = count(twin.repeated);
  report.opposedTriangles =
      static_cast<int>(std::ranges::count_if(twin.opposite, [](int other) { return other >= 0; }));
  for (const Vector3i& triangle : sound) report.flatTriangles += isFlat(triangle, mesh.points) ? 1 : 0;
  return sound;
}

/// Lengths of the connected pieces that open edges form, longest first.
std::vector<int> pieceLengths(const std::vector<EdgeUse>& open, std::size_t pointCount) {
  DisjointSets sets(pointCount);
  for (const EdgeUse& edge : open) sets.unite(edge.low, edge.high);
  std::map<int, int> lengthOf;
  for (const EdgeUse& edge : open) ++lengthOf[sets.find(edge.low)];
  std::vector<int> lengths;
  lengths.reserve(lengthOf.size());
  for (const auto& [first, length] : lengthOf) lengths.push_back(length);
  std::sort(lengths.rbegin(), lengths.rend());
  return lengths;
}

void lookAtEdges(const std::vector<Vector3i>& triangles, MeshReport& report) {
  std::vector<EdgeUse> open;
  forEachEdge(edgeUses(triangles), [&](std::span<const EdgeUse> edge) {
    ++report.edges;
    if (edge.size() == 1) open.push_back(edge[0]);
    if (edge.size() == 2 && !isOriented(edge)) ++report.misorientedEdges;
    if (edge.size() > 2) ++report.nonManifoldEdges;
  });
  report.boundaryEdges = static_cast<int>(open.size());
  report.holes = pieceLengths(open, report.points);
  const int between = report.edges - report.boundaryEdges - report.nonManifoldEdges;
  report.isClosed = report.edges > 0 && between == report.edges;
  report.isSoup = 4 * between < 3 * report.edges;
}

void lookAtComponents(const TriangleMesh& mesh, const std::vector<Vector3i>& triangles, MeshReport& report) {
  const std::vector<Component> all = components(triangles);
  report.components = static_cast<int>(all.size());
  for (const Component& component : all)
    if (component.isClosed && signedVolume(mesh.points, gather(triangles, component.triangles)) < 0)
      ++report.insideOutComponents;
}

std::string listed(const std::vector<int>& numbers) {
  constexpr std::size_t most = 8;
  std::string text;
  for (std::size_t i = 0; i < std::min(numbers.size(), most); ++i)
    text += (i > 0 ? ", " : "") + std::to_string(numbers[i]);
  return numbers.size() > most ? text + ", ..." : text;
}

}  // namespace

MeshReport analyze(const TriangleMesh& mesh) {
  MeshReport report;
  lookAtPoints(mesh, report);
  const std::vector<Vector3i> sound = lookAtTriangles(mesh, report);
  lookAtEdges(sound, report);
  lookAtComponents(mesh, sound, report);
  report.volume = signedVolume(mesh.points, sound);
  report.area = surfaceArea(mesh.points, sound);
  return report;
}

std::vector<std::string> faults(const MeshReport& report) {
  std::vector<std::string> lines;
  const auto say = [&lines](int number, const std::string& one, const std::string& many) {
    if (number > 0) lines.push_back(std::to_string(number) + " " + (number == 1 ? one : many));
  };
  if (report.triangles == 0) lines.emplace_back("no triangles");
  say(report.nonFinitePoints, "point is not finite", "points are not finite");
  say(report.duplicatePoints, "duplicate point", "duplicate points");
  say(report.unreferencedPoints, "point is in no triangle", "points are in no triangle");
  say(report.outOfRangeTriangles, "triangle uses points that don't exist",
      "triangles use points that don't exist");
  say(report.degenerateTriangles, "triangle uses a point twice", "triangles use a point twice");
  say(report.duplicateTriangles, "duplicate triangle", "duplicate triangles");
  say(report.opposedTriangles, "triangle is back to back with another",
      "triangles are back to back with others");
  say(report.flatTriangles, "triangle without area", "triangles without area");
  const std::string around = " around " + std::to_string(report.holes.size()) +
                             (report.holes.size() == 1 ? " hole (" : " holes (") + listed(report.holes) + ")";
  say(report.boundaryEdges, "boundary edge" + around, "boundary edges" + around);
  say(report.nonManifoldEdges, "edge of more than two triangles", "edges of more than two triangles");
  say(report.misorientedEdges, "edge between triangles that face opposite ways",
      "edges between triangles that face opposite ways");
  say(report.insideOutComponents, "closed part is inside out", "closed parts are inside out");
  if (report.isSoup) lines.emplace_back("triangle soup: most of it doesn't hang together");
  return lines;
}

}  // namespace pleura
