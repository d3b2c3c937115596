#include <algorithm>
#include <map>

#include <gtest/gtest.h>

#include <pleura/nodes/deformable/fem/tetrahedra.h>
#include <pleura/tests/nodes/deformable/chainmail/icosphere.h>

namespace pleura {
namespace {

using Eigen::Vector3d;

double volumeOf(const SolidMesh& mesh, int tetrahedron) {
  const auto node = [&](int a) -> const Vector3d& {
    return mesh.nodes[static_cast<std::size_t>(mesh.elements[static_cast<std::size_t>(4 * tetrahedron + a)])];
  };
  return (node(1) - node(0)).cross(node(2) - node(0)).dot(node(3) - node(0)) / 6;
}

TEST(Tetrahedra, FillTheCellsOfALattice) {
  const Lattice lattice = makeLattice(icosphere(3, 0.05F), {.elements = 200});
  const SolidMesh cut = cutIntoTetrahedra(lattice);
  ASSERT_EQ(cut.elementCount(), kTetrahedraPerCell * lattice.solid.elementCount());
  ASSERT_EQ(cut.fill.size(), static_cast<std::size_t>(cut.elementCount()));
  double filled = 0, least = 1;
  for (int t = 0; t < cut.elementCount(); ++t) {
    least = std::min(least, volumeOf(cut, t));
    filled += cut.fill[static_cast<std::size_t>(t)] * volumeOf(cut, t);
  }
  EXPECT_GT(least, 0);
  EXPECT_NEAR(filled, lattice.report.filledVolume, 1e-12 * filled);
}

/// A face belongs to one tetrahedron or to two, which see it from its two sides.
TEST(Tetrahedra, FitFromCellToCell) {
  const SolidMesh cut = cutIntoTetrahedra(makeLattice(icosphere(3, 0.05F), {.elements = 200}));
  std::map<std::array<int, 3>, std::vector<bool>> uses;  // of a face by ascending nodes: whether turned so
  for (int t = 0; t < cut.elementCount(); ++t) {
    static constexpr int kFaces[4][3] = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}};
    for (const auto& corners : kFaces) {
      std::array<int, 3> face;
      for (std::size_t k = 0; k < 3; ++k)
        face[k] = cut.elements[static_cast<std::size_t>(4 * t + corners[k])];
      std::rotate(face.begin(), std::min_element(face.begin(), face.end()), face.end());
      const bool turned = face[1] > face[2];
      if (turned) std::swap(face[1], face[2]);
      uses[face].push_back(turned);
    }
  }
  int inside = 0;
  for (const auto& [face, sides] : uses) {
    ASSERT_LE(sides.size(), 2U);
    if (sides.size() < 2) continue;
    EXPECT_NE(sides[0], sides[1]);
    ++inside;
  }
  // all but those of the lattice's outside, two a square
  EXPECT_GT(inside, 6 * cut.elementCount() / 5);
}

}  // namespace
}  // namespace pleura
