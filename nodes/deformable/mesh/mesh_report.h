#pragma once

#include <string>
#include <vector>

#include <Eigen/Geometry>

#include <pleura/nodes/deformable/mesh/triangle_mesh.h>

namespace pleura {

/// What a surface is like and what is wrong with it. Triangles out of range, with points that aren't finite
/// or that repeat a point are counted and then left out of all that follows them here.
struct MeshReport {
  int points = 0;
  int triangles = 0;
  int nonFinitePoints = 0;
  int duplicatePoints = 0;  // exactly where an earlier one is
  int unreferencedPoints = 0;
  int outOfRangeTriangles = 0;  // use a point that isn't there
  int degenerateTriangles = 0;  // use a point twice

  int duplicateTriangles = 0;  // of an earlier one's three points, in the same sense
  int opposedTriangles = 0;    // back to back with another of the same three points
  int flatTriangles = 0;       // three points in a line
  int edges = 0;
  int boundaryEdges = 0;        // used by one triangle
  int nonManifoldEdges = 0;     // used by more than two
  int misorientedEdges = 0;     // two triangles run through them in the same direction
  std::vector<int> holes;       // edges of each connected boundary, longest first
  int components = 0;           // of triangles that share edges
  int insideOutComponents = 0;  // closed, with a negative volume; cavities too
  bool isClosed = false;        // every edge between two triangles, and there is one
  bool isSoup = false;          // under three quarters of the edges are between two triangles
  double volume = 0;            // [m^3], signedVolume()
  double area = 0;              // [m^2]
  Eigen::AlignedBox3f box;      // [m], of finite points
};

/// Looks a surface over. Takes anything; n log n.
MeshReport analyze(const TriangleMesh& mesh);

/// A line for each fault, such as "8 boundary edges around 1 hole (8)"; none for a sound closed surface.
std::vector<std::string> faults(const MeshReport& report);

}  // namespace pleura
