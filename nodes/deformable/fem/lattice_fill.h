#pragma once

#include <utility>
#include <vector>

#include <pleura/nodes/deformable/fem/closed_surface.h>
#include <pleura/nodes/deformable/fem/lattice_grid.h>

namespace pleura {

/// A part of the body that is in a cell.
struct CellPart {
  int cell, part;
  bool operator==(const CellPart&) const = default;
  bool operator<(const CellPart& other) const {
    return std::pair(cell, part) < std::pair(other.cell, other.part);
  }
};

/// What a body fills of each cell of a grid.
struct LatticeFill {
  std::vector<double> fill;     // [0, 1], for each cell
  std::vector<CellPart> parts;  // ascending; of cells that the surface passes through or the body fills
  double volume = 0;            // [m^3] inside
  double crossedVolume = 0;     // [m^3] wound around otherwise than once: there the surface crosses itself
};

/// Inside is where the surface winds around at all. Lines along each axis are cut at its triangles; what lies
/// inside of them is exact, the mean over lines of all three directions is the fill. Crossings are counted by
/// sides (winding number of a triangle's image = sum over its sides), so that on every line they cancel to
/// the last bit whatever the rounding: nothing leaks. Parts that
/// overlap on a line are one, and so are a part and its cavities.
/// Throws std::invalid_argument on a surface too crowded for that (over 2^25 crossings of lines, or triangles
/// that span over 4e9 cells and lines in all). Memory: 24 bytes a crossing, 12 a cell, 8 an entry of `parts`.
LatticeFill fillLattice(const ClosedSurface& surface, const LatticeGrid& grid);

}  // namespace pleura
