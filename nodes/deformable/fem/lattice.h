#pragma once

#include <span>
#include <string>
#include <vector>

#include <Eigen/Core>

#include <pleura/nodes/deformable/fem/lattice_grid.h>
#include <pleura/nodes/deformable/fem/solid_mesh.h>
#include <pleura/nodes/deformable/mesh/triangle_mesh.h>

namespace pleura {

struct LatticeOptions {
  int elements = 5000;  ///< wanted, 1 to 1,000,000; met within a tenth where whole cells can
  double cellSize = 0;  ///< h [m]; above 0 it decides instead
  /// Least fill, (0, 1]. A node of none but cells that fill little has that part of the others' stiffness, so
  /// K's condition grows as 1 / leastFill; a hundredth adds two digits to what the mesh itself costs.
  double leastFill = 0.01;
};

/// What was found and made, for the scene's author.
struct LatticeReport {
  int elements = 0;
  int nodes = 0;
  int bodies = 0;            // of elements that hang together by nodes
  int raised = 0;            // elements given leastFill
  double cellSize = 0;       // h [m]
  double filledVolume = 0;   // [m^3] sum of fill h^3
  double insideVolume = 0;   // [m^3] inside the surface, before fill was raised; overlaps count once
  double surfaceVolume = 0;  // [m^3] by the divergence theorem; overlaps count as often as wound around
  double crossedVolume = 0;  // [m^3] above 0: the surface probably crosses itself
  int openEdges = 0;         // closed for the purpose
  int holes = 0;
  int droppedTriangles = 0;  // degenerate and duplicate
  int turnedTriangles = 0;
  int turnedParts = 0;
  bool wasInsideOut = false;
};

/// A body of trilinear hexahedra, the cubic cells of a grid that its surface passes through or that lie
/// inside, each with the part of it that is inside.
struct Lattice {
  SolidMesh solid;  // elements by ascending cell, nodes by ascending place
  LatticeGrid grid;
  std::vector<int> elementOf;  // for each cell of the grid; -1: none
  LatticeReport report;
};

/// The lattice inside a closed or nearly closed surface. Cells of separate parts share nodes only around a
/// cell that holds both; parts of one body share them wherever their cells meet, across a gap narrower than a
/// cell too. Time and memory linear but for a sort of the edges: about 200 bytes a triangle, 50 a cell of the
/// block around the body, 24 a crossing of lines. Throws std::invalid_argument on options out of range, on no
/// triangles, points that aren't finite, indices out of range, a surface that is mostly open or encloses no
/// volume, and on more than 2^23 cells in the block.
Lattice makeLattice(std::span<const Eigen::Vector3f> points, std::span<const Eigen::Vector3i> triangles,
                    const LatticeOptions& options = {});

inline Lattice makeLattice(const TriangleMesh& mesh, const LatticeOptions& options = {}) {
  return makeLattice(mesh.points, mesh.triangles, options);
}

/// A line for each thing the author should know, such as "12 open edges around 1 hole closed"; none for a
/// sound surface.
std::vector<std::string> findings(const LatticeReport& report);

}  // namespace pleura
