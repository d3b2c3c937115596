#include <cmath>
#include <stdexcept>

#include <Eigen/SparseCholesky>

#include <pleura/nodes/lung/planar/condensed_lung.h>
#include <pleura/nodes/lung/planar/plane_strain.h>

namespace pleura::planar {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::Vector2d;

CondensedLung::CondensedLung(const LungMesh& mesh, const LungTissue& tissue, double thickness)
    : rest(mesh.points), outlineCount(mesh.outlineCount), firstFree(mesh.heldCount + 1) {
  const bool isFinite = std::isfinite(tissue.youngsModulus) && std::isfinite(tissue.poissonsRatio) &&
                        std::isfinite(tissue.density) && std::isfinite(tissue.relaxationTime);
  const bool isTissue = isFinite && tissue.youngsModulus > 0 && tissue.poissonsRatio > -1 &&
                        tissue.poissonsRatio < 0.5 && tissue.density > 0 && tissue.relaxationTime >= 0;
  if (!isTissue) throw std::invalid_argument("lung: tissue outside its range");
  const Index outer = 2 * outlineCount;
  const Index first = 2 * firstFree;
  const Index free = outer - Index{2} * (2 * mesh.heldCount + 1);
  const Index inner = 2 * static_cast<Index>(rest.size()) - outer;

  using Sparse = Eigen::SparseMatrix<double>;
  const Sparse k = stiffnessMatrix(mesh, tissue, thickness);
  const Sparse m = massMatrix(mesh, tissue, thickness);
  const MatrixXd k_io = k.block(outer, first, inner, free);
  const MatrixXd m_io = m.block(outer, first, inner, free);
  const Eigen::SimplicialLDLT<Sparse> k_ii(Sparse(k.block(outer, outer, inner, inner)));
  inside = -k_ii.solve(k_io);
  if (k_ii.info() != Eigen::Success || !inside.allFinite())
    throw std::invalid_argument("lung: its mesh is not stiff");
  stiffness = MatrixXd(k.block(first, first, free, free)) + k_io.transpose() * inside;
  const MatrixXd across = m_io.transpose() * inside;
  mass = MatrixXd(m.block(first, first, free, free)) + across + across.transpose() +
         inside.transpose() * (m.block(outer, outer, inner, inner) * inside);
  stiffness = (stiffness + stiffness.transpose()).eval() / 2;  // symmetric to the bit
  mass = (mass + mass.transpose()).eval() / 2;
}

void CondensedLung::place(const Eigen::VectorXd& displacement, std::span<Vector2d> points) const {
  for (std::size_t i = 0; i < points.size(); ++i) points[i] = rest[i];
  for (Index f = 0; f < size() / 2; ++f)
    points[static_cast<std::size_t>(firstFree + f)] += displacement.segment<2>(2 * f);
  for (Index row = 0; row < inside.rows(); ++row)
    points[static_cast<std::size_t>(outlineCount + row / 2)][row % 2] += inside.row(row).dot(displacement);
}

}  // namespace pleura::planar
