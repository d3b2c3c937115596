#include <algorithm>
#include <utility>

#include <pleura/nodes/deformable/fem/tetrahedra.h>

namespace pleura {

void addTetrahedra(const std::array<int, 8>& corner, bool flip, std::vector<int>& elements) {
  static constexpr std::array<std::array<std::size_t, 4>, kTetrahedraPerCell> kFive{
      {{0, 1, 2, 4}, {3, 2, 1, 7}, {5, 4, 7, 1}, {6, 7, 4, 2}, {1, 2, 4, 7}}};
  for (const auto& tetrahedron : kFive) {
    std::array<int, 4> nodes;
    for (std::size_t a = 0; a < 4; ++a) nodes[a] = corner[tetrahedron[a] ^ (flip ? 1U : 0U)];
    if (flip) std::swap(nodes[2], nodes[3]);
    elements.insert(elements.end(), nodes.begin(), nodes.end());
  }
}

SolidMesh cutIntoTetrahedra(const Lattice& lattice) {
  SolidMesh cut{lattice.solid.nodes, {}, 4, {}};
  for (int cell = 0; cell < lattice.grid.cellCount(); ++cell) {
    const int element = lattice.elementOf[static_cast<std::size_t>(cell)];
    if (element < 0) continue;
    std::array<int, 8> corner;
    std::copy_n(lattice.solid.elements.begin() + 8L * element, 8, corner.begin());
    addTetrahedra(corner, lattice.grid.cellOf(cell).sum() % 2 == 1, cut.elements);
    cut.fill.insert(cut.fill.end(), kTetrahedraPerCell,
                    lattice.solid.fill[static_cast<std::size_t>(element)]);
  }
  return cut;
}

}  // namespace pleura
