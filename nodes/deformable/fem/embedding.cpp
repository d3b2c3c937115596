#include <cassert>
#include <stdexcept>
#include <string>

#include <pleura/nodes/deformable/fem/embedding.h>
#include <pleura/nodes/deformable/mesh/measures.h>

namespace pleura {

namespace {

using Eigen::Vector3d;
using Eigen::Vector3i;

/// For each cell of the grid the element that the fewest steps through faces lead to.
std::vector<int> nearElements(const Lattice& lattice) {
  const LatticeGrid& grid = lattice.grid;
  std::vector<int> near = lattice.elementOf;
  std::vector<int> front;
  for (int cell = 0; cell < grid.cellCount(); ++cell)
    if (near[cell] >= 0) front.push_back(cell);
  for (std::size_t i = 0; i < front.size(); ++i) {
    const Vector3i cell = grid.cellOf(front[i]);
    for (int side = 0; side < 6; ++side) {
      Vector3i next = cell;
      next[side / 2] += side % 2 == 0 ? -1 : 1;
      if ((next.array() < 0 || next.array() >= grid.cells.array()).any()) continue;
      const int number = grid.cellNumber(next);
      if (near[number] >= 0) continue;
      near[number] = near[front[i]];
      front.push_back(number);
    }
  }
  return near;
}

/// The element's low corner [m].
Vector3d lowCorner(const Lattice& lattice, int element) {
  return lattice.solid.nodes[lattice.solid.elements[8 * static_cast<std::size_t>(element)]];
}

}  // namespace

Embedding embed(const Lattice& lattice, std::span<const Eigen::Vector3f> points) {
  requireFinite(points);
  if (lattice.solid.elements.empty()) throw std::invalid_argument("lattice: has no elements");
  const auto isElement = [&lattice](int cell) { return lattice.elementOf[cell] >= 0; };
  Embedding embedding;
  embedding.nodeCount = static_cast<int>(lattice.solid.nodes.size());
  embedding.elements.reserve(points.size());
  embedding.nodes.reserve(8 * points.size());
  embedding.weights.reserve(8 * points.size());
  std::vector<int> near;
  for (const Eigen::Vector3f& point : points) {
    const Vector3d p = point.cast<double>();
    const int cell = lattice.grid.cellAround(lattice.grid.local(p), isElement);
    if (cell < 0) {
      ++embedding.outside;
      if (near.empty()) near = nearElements(lattice);
    }
    const int element = cell >= 0
                            ? lattice.elementOf[cell]
                            : near[lattice.grid.cellNumber(lattice.grid.nearestCell(lattice.grid.local(p)))];
    const Vector3d t = (p - lowCorner(lattice, element)) / lattice.grid.cellSize;
    embedding.elements.push_back(element);
    for (int a = 0; a < 8; ++a) {
      embedding.nodes.push_back(lattice.solid.elements[8 * static_cast<std::size_t>(element) + a]);
      embedding.weights.push_back(((a & 1) != 0 ? t.x() : 1 - t.x()) * ((a & 2) != 0 ? t.y() : 1 - t.y()) *
                                  ((a & 4) != 0 ? t.z() : 1 - t.z()));
    }
  }
  return embedding;
}

void interpolate(const Embedding& embedding, std::span<const Vector3d> nodes, std::span<Vector3d> points) {
  assert(std::ssize(nodes) == embedding.nodeCount && std::ssize(points) == embedding.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    Vector3d x = Vector3d::Zero();
    for (std::size_t k = 8 * i; k < 8 * (i + 1); ++k) x += embedding.weights[k] * nodes[embedding.nodes[k]];
    points[i] = x;
  }
}

void addTransposed(const Embedding& embedding, std::span<const Vector3d> pointForces,
                   std::span<Vector3d> nodeForces) {
  assert(std::ssize(nodeForces) == embedding.nodeCount && std::ssize(pointForces) == embedding.size());
  for (std::size_t i = 0; i < pointForces.size(); ++i)
    for (std::size_t k = 8 * i; k < 8 * (i + 1); ++k)
      nodeForces[embedding.nodes[k]] += embedding.weights[k] * pointForces[i];
}

}  // namespace pleura
