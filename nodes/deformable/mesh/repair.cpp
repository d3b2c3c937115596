#include <algorithm>
#include <stdexcept>

#include <pleura/nodes/deformable/mesh/holes.h>
#include <pleura/nodes/deformable/mesh/manifold.h>
#include <pleura/nodes/deformable/mesh/orientation.h>
#include <pleura/nodes/deformable/mesh/repair.h>
#include <pleura/nodes/deformable/mesh/triangle_checks.h>
#include <pleura/nodes/deformable/mesh/weld.h>

namespace pleura {

namespace {

using Eigen::Vector3i;

int dropUnusable(TriangleMesh& mesh) {
  const auto unusable = [&mesh](const Vector3i& triangle) {
    return !isInRange(triangle, mesh.points.size()) || !isFinite(triangle, mesh.points);
  };
  return static_cast<int>(std::erase_if(mesh.triangles, unusable));
}

int weld(TriangleMesh& mesh, double distance) {
  const std::vector<int> standIn = weldedPoints(mesh.points, distance);
  for (Vector3i& triangle : mesh.triangles)
    for (int& corner : triangle) corner = standIn[corner];
  int welded = 0;
  for (int i = 0; i < std::ssize(standIn); ++i) welded += standIn[i] != i ? 1 : 0;
  return welded;
}

/// Two triangles back to back enclose nothing: both go. But where most are, the surface is a sheet drawn from
/// both sides, and keeps one.
int dropRepeats(std::vector<Vector3i>& triangles) {
  const auto before = triangles.size();
  std::erase_if(triangles, repeatsPoint);
  const auto [repeated, opposite] = twins(triangles);
  const auto paired = std::ranges::count_if(opposite, [](int other) { return other >= 0; });
  const bool isTwoSided = 2 * paired > std::ssize(triangles);
  int kept = 0;
  for (int t = 0; t < std::ssize(triangles); ++t) {
    const bool staysOfPair = isTwoSided && t < opposite[t];
    if (!repeated[t] && (opposite[t] < 0 || staysOfPair)) triangles[kept++] = Vector3i(triangles[t]);
  }
  triangles.resize(kept);
  return static_cast<int>(before) - kept;
}

}  // namespace

int removeUnreferencedPoints(TriangleMesh& mesh) {
  std::vector<int> newIndex(mesh.points.size(), -1);
  for (const Vector3i& triangle : mesh.triangles)
    for (const int corner : triangle) newIndex[corner] = 0;
  int kept = 0;
  for (std::size_t i = 0; i < mesh.points.size(); ++i) {
    if (newIndex[i] < 0) continue;
    newIndex[i] = kept;
    mesh.points[kept++] = Eigen::Vector3f(mesh.points[i]);
  }
  const int removed = static_cast<int>(mesh.points.size()) - kept;
  mesh.points.resize(kept);
  for (Vector3i& triangle : mesh.triangles)
    for (int& corner : triangle) corner = newIndex[corner];
  return removed;
}

RepairReport repair(TriangleMesh& mesh, const RepairOptions& options) {
  if (options.maxHoleEdges < 0) throw std::invalid_argument("maxHoleEdges: must not be negative");
  RepairReport report;
  report.droppedTriangles = dropUnusable(mesh);
  report.weldedPoints = weld(mesh, options.weldDistance);
  report.droppedTriangles += dropRepeats(mesh.triangles);
  if (options.orient) report.turnedTriangles = orientConsistently(mesh.triangles);
  report.splitPoints = splitFans(mesh);
  report.filledHoles = fillHoles(mesh, options.maxHoleEdges);
  report.removedPoints = removeUnreferencedPoints(mesh);
  if (options.orient) report.turnedParts = faceOutwards(mesh.points, mesh.triangles);
  return report;
}

std::vector<std::string> deeds(const RepairReport& report) {
  std::vector<std::string> lines;
  const auto say = [&lines](const std::string& verb, int number, const std::string& noun) {
    if (number > 0)
      lines.push_back(verb + " " + std::to_string(number) + " " + noun + (number > 1 ? "s" : ""));
  };
  say("welded", report.weldedPoints, "point");
  say("dropped", report.droppedTriangles, "unusable or repeated triangle");
  say("turned", report.turnedTriangles, "triangle");
  say("split", report.splitPoints, "point");
  say("filled", report.filledHoles, "hole");
  say("turned", report.turnedParts, "inside-out part");
  say("removed", report.removedPoints, "unused point");
  return lines;
}

}  // namespace pleura
