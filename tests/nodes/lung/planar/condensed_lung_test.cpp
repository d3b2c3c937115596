#include <cmath>
#include <limits>
#include <stdexcept>

#include <Eigen/Eigenvalues>
#include <gtest/gtest.h>

#include <pleura/nodes/lung/planar/condensed_lung.h>
#include <pleura/nodes/lung/planar/plane_strain.h>

namespace pleura::planar {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::Vector2d;
using Eigen::VectorXd;

constexpr double kThickness = 0.08;

TEST(CondensedLung, PatchTestIsExact) {
  LungMesh mesh = makeHemithorax({}).lung;
  mesh.heldCount = 0;  // the one point left may lie anywhere
  const CondensedLung lung(mesh, {}, kThickness);
  Eigen::Matrix2d gradient;
  gradient << 0.1, -0.03, 0.07, 0.05;
  const auto u = [&](std::size_t i) -> Vector2d { return gradient * (mesh.points[i] - mesh.points[0]); };
  VectorXd outline(lung.size());
  for (Index f = 0; f < lung.size() / 2; ++f)
    outline.segment<2>(2 * f) = u(static_cast<std::size_t>(lung.firstFree + f));
  std::vector<Vector2d> points(mesh.points.size());
  lung.place(outline, points);
  for (std::size_t i = 0; i < points.size(); ++i)
    EXPECT_NEAR((points[i] - mesh.points[i] - u(i)).norm(), 0, 1e-14) << i;
}

TEST(CondensedLung, IsAsStiffAsTheWholeAndSwingsAsSlowly) {
  const LungMesh mesh = makeHemithorax({}).lung;
  const CondensedLung lung(mesh, {}, kThickness);
  // the whole mesh, its held points cut out
  const Index first = Index{2} * (mesh.heldCount + 1);
  const MatrixXd k = stiffnessMatrix(mesh, {}, kThickness);
  const MatrixXd m = massMatrix(mesh, {}, kThickness);
  std::vector<Index> free;
  for (Index i = first; i < k.rows(); ++i)
    if (i < first + lung.size() || i >= Index{2} * mesh.outlineCount) free.push_back(i);
  const MatrixXd k_free = k(free, free);
  const MatrixXd m_free = m(free, free);
  VectorXd load = VectorXd::Zero(k_free.rows());
  for (Index i = 0; i < lung.size(); ++i) load[i] = std::sin(1.0 + static_cast<double>(i));
  const VectorXd whole = k_free.llt().solve(load);
  const VectorXd condensed = lung.stiffness.llt().solve(load.head(lung.size()));
  EXPECT_NEAR((whole.head(lung.size()) - condensed).norm(), 0, 1e-10 * condensed.norm());

  const auto lowest = [](const MatrixXd& a, const MatrixXd& b) {
    return std::sqrt(Eigen::GeneralizedSelfAdjointEigenSolver<MatrixXd>(a, b).eigenvalues()[0]);
  };
  const double exact = lowest(k_free, m_free);
  const double guyan = lowest(lung.stiffness, lung.mass);
  EXPECT_GT(guyan, exact) << "from above, as Rayleigh's quotient";
  EXPECT_LT(guyan, 1.05 * exact);
  EXPECT_GT(exact / (2 * 3.14159), 3 * 0.25) << "[Hz]: a breath is slow against it";
}

TEST(CondensedLung, TissueOutsideItsRangeIsRefused) {
  const LungMesh mesh = makeHemithorax({}).lung;
  constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
  for (const LungTissue& tissue :
       {LungTissue{.youngsModulus = 0}, LungTissue{.youngsModulus = kNaN}, LungTissue{.poissonsRatio = 0.5},
        LungTissue{.poissonsRatio = -1}, LungTissue{.density = 0}, LungTissue{.relaxationTime = -1}})
    EXPECT_THROW(CondensedLung(mesh, tissue, kThickness), std::invalid_argument);
}

}  // namespace
}  // namespace pleura::planar
