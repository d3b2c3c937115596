#pragma once

#include <string>
#include <vector>

#include <pleura/nodes/deformable/mesh/triangle_mesh.h>

namespace pleura {

struct RepairOptions {
  double weldDistance = 0;  // [m], points no farther apart become one; 0: points at the same place
  int maxHoleEdges = 64;    // longer holes stay open; 0: all do
  bool orient = true;       // make neighbours face the same way and closed parts outwards
};

/// What a repair did, in numbers.
struct RepairReport {
  int weldedPoints = 0;
  int droppedTriangles = 0;  // out of range, not finite, of repeated points, duplicates
  int turnedTriangles = 0;
  int splitPoints = 0;  // copies made where sheets only touched
  int filledHoles = 0;
  int turnedParts = 0;    // closed parts that were inside out
  int removedPoints = 0;  // of no triangle
};

/// Makes a surface fit to work with, whatever it was: afterwards all is finite and in range, no triangle
/// repeats a point or another triangle, each edge has at most two triangles and (with `orient`) these face
/// the same way. Flat triangles stay, since a surface without them has slits. n log n. Throws
/// std::invalid_argument on bad options and as faceOutwards does.
RepairReport repair(TriangleMesh& mesh, const RepairOptions& options = {});

/// A line for each thing done, such as "filled 1 hole".
std::vector<std::string> deeds(const RepairReport& report);

/// Takes out points of no triangle, the others stay in order; returns how many. Indices must be in range.
int removeUnreferencedPoints(TriangleMesh& mesh);

}  // namespace pleura
