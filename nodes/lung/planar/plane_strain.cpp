#include <array>
#include <cmath>
#include <vector>

#include <pleura/nodes/lung/planar/plane_strain.h>
#include <pleura/nodes/lung/planar/polygon.h>

namespace pleura::planar {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3i;
using StrainOfPoint = Eigen::Matrix<double, 3, 2>;

struct Triangle {
  double area = 0;                      // [m^2] >= 0
  std::array<StrainOfPoint, 3> strain;  // B_a: displacement of a corner to strain (xx, yy, 2 xy) [1/m]
};

Triangle triangleOf(const LungMesh& mesh, const Vector3i& corners) {
  const auto p = [&](int a) { return mesh.points[static_cast<std::size_t>(corners[a % 3])]; };
  const double twice = cross(p(1) - p(0), p(2) - p(0));
  Triangle triangle{std::abs(twice) / 2, {}};
  for (int a = 0; a < 3; ++a) {
    const Vector2d opposite = p(a + 2) - p(a + 1);
    const Vector2d g = Vector2d(-opposite.y(), opposite.x()) / twice;  // gradient of the shape function
    triangle.strain[static_cast<std::size_t>(a)] << g.x(), 0, 0, g.y(), g.y(), g.x();
  }
  return triangle;
}

/// Sums block(triangle, a, b), 2 x 2, over all pairs of corners.
template <class Block>
Eigen::SparseMatrix<double> assemble(const LungMesh& mesh, const Block& block) {
  std::vector<Eigen::Triplet<double>> entries;
  entries.reserve(36 * mesh.triangles.size());
  for (const Vector3i& corners : mesh.triangles) {
    const Triangle triangle = triangleOf(mesh, corners);
    for (int a = 0; a < 3; ++a) {
      for (int b = 0; b < 3; ++b) {
        const Eigen::Matrix2d part = block(triangle, a, b);
        for (int i = 0; i < 2; ++i)
          for (int j = 0; j < 2; ++j)
            entries.emplace_back(2 * corners[a] + i, 2 * corners[b] + j, part(i, j));
      }
    }
  }
  const auto size = static_cast<Eigen::Index>(2 * mesh.points.size());
  Eigen::SparseMatrix<double> matrix(size, size);
  matrix.setFromTriplets(entries.begin(), entries.end());
  return matrix;
}

}  // namespace

Eigen::Matrix3d planeStrain(double youngsModulus, double poissonsRatio) {
  const double nu = poissonsRatio;
  Eigen::Matrix3d c;
  c << 1 - nu, nu, 0, nu, 1 - nu, 0, 0, 0, 0.5 - nu;
  return youngsModulus / ((1 + nu) * (1 - 2 * nu)) * c;
}

Eigen::SparseMatrix<double> stiffnessMatrix(const LungMesh& mesh, const LungTissue& tissue,
                                            double thickness) {
  const Eigen::Matrix3d c = planeStrain(tissue.youngsModulus, tissue.poissonsRatio);
  return assemble(mesh, [&](const Triangle& t, int a, int b) -> Eigen::Matrix2d {
    return thickness * t.area * t.strain[static_cast<std::size_t>(a)].transpose() * c *
           t.strain[static_cast<std::size_t>(b)];
  });
}

Eigen::SparseMatrix<double> massMatrix(const LungMesh& mesh, const LungTissue& tissue, double thickness) {
  return assemble(mesh, [&](const Triangle& t, int a, int b) -> Eigen::Matrix2d {
    return tissue.density * thickness * t.area * (a == b ? 2 : 1) / 12 * Eigen::Matrix2d::Identity();
  });
}

}  // namespace pleura::planar
