#pragma once

#include <array>
#include <vector>

#include <pleura/nodes/deformable/fem/lattice.h>

namespace pleura {

/// Tetrahedra that a cell is cut into.
inline constexpr int kTetrahedraPerCell = 5;

/// Appends the five tetrahedra of a cell whose corners are given in the order of bits, mirrored along x if
/// `flip`: those of cells that share a face fit when one of the two is.
void addTetrahedra(const std::array<int, 8>& corner, bool flip, std::vector<int>& elements);

/// The lattice's body with each cube cut into tetrahedra, of the same nodes in the same order. Stiffer than
/// the cubes, above all where nu is near 0.5: linear tetrahedra lock there.
SolidMesh cutIntoTetrahedra(const Lattice& lattice);

}  // namespace pleura
