#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <stdexcept>
#include <utility>

#include <Eigen/Geometry>

#include <pleura/nodes/deformable/fem/closed_surface.h>
#include <pleura/nodes/deformable/fem/lattice.h>
#include <pleura/nodes/deformable/fem/lattice_fill.h>
#include <pleura/nodes/deformable/mesh/disjoint_sets.h>
#include <pleura/nodes/deformable/mesh/measures.h>

namespace pleura {

namespace {

using Eigen::AlignedBox3d;
using Eigen::Vector3d;
using Eigen::Vector3f;
using Eigen::Vector3i;

constexpr int mostElements = 1'000'000;
constexpr double mostCells = 1 << 23;

void requireInRange(const LatticeOptions& options) {
  if (options.elements < 1 || options.elements > mostElements)
    throw std::invalid_argument("elements: must be from 1 to " + std::to_string(mostElements) + ", is " +
                                std::to_string(options.elements));
  if (!std::isfinite(options.cellSize) || options.cellSize < 0)
    throw std::invalid_argument("cellSize: must be 0 or a length in metres");
  if (!(options.leastFill > 0 && options.leastFill <= 1))
    throw std::invalid_argument("leastFill: must be above 0 and at most 1");
}

[[noreturn]] void refuseNoVolume() {
  throw std::invalid_argument("triangles: the surface encloses no volume");
}

AlignedBox3d boxOf(const TriangleMesh& mesh) {
  AlignedBox3d box;
  for (const Vector3i& triangle : mesh.triangles)
    for (const int corner : triangle) box.extend(mesh.points[corner].cast<double>());
  return box;
}

/// Cells of size h around the box, in the middle.
LatticeGrid gridAround(const AlignedBox3d& box, double h) {
  LatticeGrid grid;
  grid.cellSize = h;
  const Vector3d counts =
      (box.sizes() / h).array().min(2 * mostCells).max(LatticeGrid::tolerance) - LatticeGrid::tolerance;
  grid.cells = counts.array().ceil().max(1).cast<int>();
  if (grid.cells.cast<double>().prod() > mostCells)
    throw std::invalid_argument("cells of " + std::to_string(h) + " m are too small: over " +
                                std::to_string(static_cast<int>(mostCells)) + " in the block around a body " +
                                std::to_string(box.sizes().maxCoeff()) + " m long");
  grid.origin = box.center() - grid.cells.cast<double>() * (h / 2);
  return grid;
}

struct FilledGrid {
  LatticeGrid grid;
  LatticeFill fill;

  int elements() const {
    int count = 0, last = -1;
    for (const auto& [cell, part] : fill.parts) count += std::exchange(last, cell) != cell ? 1 : 0;
    return count;
  }
};

FilledGrid fillWithCells(const ClosedSurface& surface, const AlignedBox3d& box, double h) {
  FilledGrid cells{gridAround(box, h), {}};
  cells.fill = fillLattice(surface, cells.grid);
  return cells;
}

/// The h of V / h^3 + c A / h^2 = n: cells inside and half of those cut.
double cellSizeFor(double n, double volume, double cutArea) {
  double u = std::sqrt(n / cutArea);  // 1 / h
  if (volume > 0) u = std::min(u, std::cbrt(n / volume));
  for (int i = 0; i < 20; ++i)  // Newton from above on a convex function
    u -= (volume * u * u * u + cutArea * u * u - n) / (3 * volume * u * u + 2 * cutArea * u);
  return 1 / u;
}

/// Cells of about the wanted number: a plane of any direction cuts 3/2 cells an h^2 in the mean, half of
/// which lie outside; what was counted then corrects this c = 3/4.
FilledGrid fillWithAbout(int wanted, const ClosedSurface& surface, const AlignedBox3d& box, double area) {
  constexpr int tries = 4;
  double c = 0.75;
  std::optional<FilledGrid> best;
  int bestMiss = 0;
  for (int i = 0; i < tries; ++i) {
    const double volume = best ? best->fill.volume : std::abs(surface.volume);
    const double h = std::min(cellSizeFor(wanted, volume, c * area), box.sizes().maxCoeff());
    FilledGrid next = fillWithCells(surface, box, h);
    const int count = next.elements(), miss = std::abs(count - wanted);
    c = std::max(0.05, (count * h * h * h - next.fill.volume) / (area * h));
    if (!best || miss < bestMiss) {
      best = std::move(next);
      bestMiss = miss;
    }
    if (10 * bestMiss <= wanted) break;
  }
  return std::move(*best);
}

/// The parts in each element, in compressed form.
struct ElementParts {
  std::vector<int> offsets;
  std::vector<CellPart> items;

  bool share(int first, int second) const {
    int i = offsets[first], j = offsets[second];
    while (i < offsets[first + 1] && j < offsets[second + 1]) {
      if (items[i].part == items[j].part) return true;
      ++(items[i].part < items[j].part ? i : j);
    }
    return false;
  }
};

/// Numbers elements and takes their fill.
ElementParts makeElements(FilledGrid cells, double leastFill, Lattice& lattice) {
  lattice.grid = cells.grid;
  lattice.elementOf.assign(cells.grid.cellCount(), -1);
  lattice.solid.nodesPerElement = 8;
  ElementParts parts{{}, std::move(cells.fill.parts)};
  for (int i = 0; i < static_cast<int>(parts.items.size()); ++i) {
    const int cell = parts.items[i].cell;
    if (lattice.elementOf[cell] >= 0) continue;
    lattice.elementOf[cell] = static_cast<int>(parts.offsets.size());
    parts.offsets.push_back(i);
    const double fill = cells.fill.fill[cell];
    lattice.solid.fill.push_back(std::max(fill, leastFill));
    lattice.report.raised += fill < leastFill ? 1 : 0;
  }
  parts.offsets.push_back(static_cast<int>(parts.items.size()));
  return parts;
}

/// Gives the elements around each corner of the grid a node for each group of them that shares parts.
void makeNodes(const ElementParts& parts, Lattice& lattice) {
  const LatticeGrid& grid = lattice.grid;
  lattice.solid.elements.resize(8 * lattice.solid.fill.size());
  const auto elementAt = [&](const Vector3i& cell) {
    const bool isOutside = (cell.array() < 0 || cell.array() >= grid.cells.array()).any();
    return isOutside ? -1 : lattice.elementOf[grid.cellNumber(cell)];
  };
  const auto addNodes = [&](const Vector3i& corner) {
    std::array<int, 8> around, node;
    for (int k = 0; k < 8; ++k) {
      node[k] = -1;
      around[k] = elementAt(corner - Vector3i(k & 1, k >> 1 & 1, k >> 2));
    }
    for (int seed = 0; seed < 8; ++seed) {
      if (around[seed] < 0 || node[seed] >= 0) continue;
      const int self = node[seed] = static_cast<int>(lattice.solid.nodes.size());
      lattice.solid.nodes.push_back(grid.origin + corner.cast<double>() * grid.cellSize);
      for (bool grows = true; grows;) {
        grows = false;
        for (int k = 0; k < 8; ++k) {
          if (around[k] < 0 || node[k] >= 0) continue;
          for (int m = 0; m < 8 && node[k] < 0; ++m)
            if (node[m] == self && parts.share(around[k], around[m])) node[k] = self;
          grows = grows || node[k] >= 0;
        }
      }
    }
    for (int k = 0; k < 8; ++k)
      if (around[k] >= 0) lattice.solid.elements[8 * around[k] + k] = node[k];
  };
  Vector3i corner;
  for (corner.z() = 0; corner.z() <= grid.cells.z(); ++corner.z())
    for (corner.y() = 0; corner.y() <= grid.cells.y(); ++corner.y())
      for (corner.x() = 0; corner.x() <= grid.cells.x(); ++corner.x()) addNodes(corner);
}

int countBodies(const SolidMesh& solid) {
  DisjointSets sets(solid.nodes.size());
  for (std::size_t i = 0; i < solid.elements.size(); ++i)
    sets.unite(solid.elements[i], solid.elements[i / 8 * 8]);
  int count = 0;
  for (int i = 0; i < static_cast<int>(solid.nodes.size()); ++i) count += sets.find(i) == i ? 1 : 0;
  return count;
}

void reportOn(const ClosedSurface& surface, Lattice& lattice) {
  LatticeReport& report = lattice.report;
  report.elements = lattice.solid.elementCount();
  report.nodes = static_cast<int>(lattice.solid.nodes.size());
  report.bodies = countBodies(lattice.solid);
  report.cellSize = lattice.grid.cellSize;
  for (const double fill : lattice.solid.fill) report.filledVolume += fill;
  report.filledVolume *= std::pow(report.cellSize, 3);
  report.surfaceVolume = surface.volume;
  report.openEdges = surface.openEdges;
  report.holes = surface.holes;
  report.droppedTriangles = surface.droppedTriangles;
  report.turnedTriangles = surface.turnedTriangles;
  report.turnedParts = surface.turnedParts;
  report.wasInsideOut = surface.wasInsideOut;
}

std::string counted(int number, const std::string& one, const std::string& many) {
  return std::to_string(number) + " " + (number == 1 ? one : many);
}

/// As a person reads it: "12.5 %".
std::string percent(double part) { return std::to_string(std::round(1000 * part) / 10).substr(0, 4) + " %"; }

}  // namespace

Lattice makeLattice(std::span<const Vector3f> points, std::span<const Vector3i> triangles,
                    const LatticeOptions& options) {
  requireInRange(options);
  const ClosedSurface surface = closeSurface(points, triangles);
  const AlignedBox3d box = boxOf(surface.mesh);
  const double area = surfaceArea(surface.mesh.points, surface.mesh.triangles);
  if (area <= 0) refuseNoVolume();
  FilledGrid cells = options.cellSize > 0 ? fillWithCells(surface, box, options.cellSize)
                                          : fillWithAbout(options.elements, surface, box, area);
  // Thinner than this a body is its points' rounding.
  constexpr double thinnest = 1e-6;
  if (std::max(std::abs(surface.volume), cells.fill.volume) <= thinnest * area * box.diagonal().norm())
    refuseNoVolume();
  Lattice lattice;
  lattice.report.insideVolume = cells.fill.volume;
  lattice.report.crossedVolume = cells.fill.crossedVolume;
  makeNodes(makeElements(std::move(cells), options.leastFill, lattice), lattice);
  reportOn(surface, lattice);
  return lattice;
}

std::vector<std::string> findings(const LatticeReport& report) {
  std::vector<std::string> lines;
  if (report.openEdges > 0)
    lines.push_back(counted(report.openEdges, "open edge", "open edges") + " around " +
                    counted(report.holes, "hole", "holes") + " closed");
  if (report.droppedTriangles > 0)
    lines.push_back(counted(report.droppedTriangles, "degenerate or duplicate triangle",
                            "degenerate or duplicate triangles") +
                    " left out");
  if (report.wasInsideOut) lines.emplace_back("the surface is inside out: turned");
  if (report.turnedTriangles > 0)
    lines.push_back(counted(report.turnedTriangles, "triangle that faces", "triangles that face") +
                    " against the others turned");
  if (report.turnedParts > 0)
    lines.push_back(counted(report.turnedParts, "inside-out part", "inside-out parts") + " turned");
  if (report.crossedVolume > 1e-4 * report.insideVolume)
    lines.push_back("the surface seems to cross itself, in " +
                    percent(report.crossedVolume / report.insideVolume) + " of its volume");
  if (report.filledVolume > 1.05 * report.insideVolume)
    lines.push_back(
        "cells are too large for the body: " + percent(1 - report.insideVolume / report.filledVolume) +
        " of what they fill lies outside it");
  if (report.bodies > 1) lines.push_back(std::to_string(report.bodies) + " bodies that do not hang together");
  return lines;
}

}  // namespace pleura
