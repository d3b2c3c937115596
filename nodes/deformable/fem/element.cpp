#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <string>

#include <Eigen/Geometry>
#include <Eigen/LU>

#include <pleura/nodes/deformable/fem/element.h>

namespace pleura {
namespace {

constexpr double kFarthest = 1e6;   // [m]
constexpr double kFlattest = 1e-9;  // volume over cube of diameter
constexpr double kLargestConstant = 1e15;

using Gradients = std::array<Eigen::Vector3d, kMostElementNodes>;

void check(const SolidMesh& mesh) {
  if (mesh.nodesPerElement != 4 && mesh.nodesPerElement != 8) refuseSolid("an element has 4 or 8 nodes");
  if (mesh.elements.empty() || mesh.elements.size() % static_cast<std::size_t>(mesh.nodesPerElement) != 0)
    refuseSolid("the mesh is empty, or its last element is not whole");
  if (mesh.elements.size() / static_cast<std::size_t>(mesh.nodesPerElement) > kMostElements)
    refuseSolid(std::to_string(mesh.elements.size() / static_cast<std::size_t>(mesh.nodesPerElement)) +
                " elements, at most " + std::to_string(kMostElements) + " are taken");
  for (std::size_t i = 0; i < mesh.nodes.size(); ++i)
    for (const double x : mesh.nodes[i])
      if (!std::isfinite(x) || std::abs(x) > kFarthest)
        refuseSolid("node " + std::to_string(i) + " is not finite, or too far away");
  for (const int i : mesh.elements)
    if (i < 0 || static_cast<std::size_t>(i) >= mesh.nodes.size())
      refuseSolid("an element names node " + std::to_string(i) + " of " + std::to_string(mesh.nodes.size()));
  if (!mesh.fill.empty() && mesh.fill.size() != static_cast<std::size_t>(mesh.elementCount()))
    refuseSolid("fill has neither no entry nor one an element");
  for (const double fill : mesh.fill)
    if (!std::isfinite(fill) || fill <= 0 || fill > 1) refuseSolid("fill is outside (0, 1]");
}

// dN_a/dxi of the reference tetrahedron, or of the reference cube [-1, 1]^3 at xi.
Gradients referenceGradients(int nodesPerElement, const Eigen::Vector3d& xi) {
  Gradients gradients;
  if (nodesPerElement == 4) {
    gradients[0].setConstant(-1);
    for (int i = 0; i < 3; ++i) gradients[static_cast<std::size_t>(i) + 1] = Eigen::Vector3d::Unit(i);
    return gradients;
  }
  for (int a = 0; a < 8; ++a) {
    const Eigen::Vector3d corner((a & 1) ? 1 : -1, (a & 2) ? 1 : -1, (a & 4) ? 1 : -1);
    const Eigen::Vector3d factor = 0.5 * (Eigen::Vector3d::Ones() + corner.cwiseProduct(xi));
    gradients[a] = 0.5 * corner.cwiseProduct(Eigen::Vector3d(factor.y() * factor.z(), factor.x() * factor.z(),
                                                             factor.x() * factor.y()));
  }
  return gradients;
}

double referenceShape(int nodesPerElement, int a, const Eigen::Vector3d& xi) {
  if (nodesPerElement == 4) return 0.25;
  double shape = 1;
  for (int i = 0; i < 3; ++i) shape *= 0.5 * (1 + (((a >> i) & 1) ? xi[i] : -xi[i]));
  return shape;
}

// The quadrature points, and the volume of the reference element that each stands for.
struct Quadrature {
  std::vector<Eigen::Vector3d> points;
  double weight;
};

Quadrature quadratureOf(int nodesPerElement) {
  if (nodesPerElement == 4) return {{Eigen::Vector3d::Constant(0.25)}, 1.0 / 6};
  Quadrature gauss{{}, 1};
  const double at = 1 / std::sqrt(3.0);
  for (int q = 0; q < 8; ++q)
    gauss.points.emplace_back((q & 1) ? at : -at, (q & 2) ? at : -at, (q & 4) ? at : -at);
  return gauss;
}

double diameterOf(const SolidMesh& mesh, const int* nodes) {
  double diameter = 0;
  for (int a = 0; a < mesh.nodesPerElement; ++a)
    for (int b = 0; b < a; ++b)
      diameter = std::max(diameter, (mesh.nodes[nodes[a]] - mesh.nodes[nodes[b]]).norm());
  return diameter;
}

}  // namespace

void refuseSolid(const std::string& what) { throw std::invalid_argument("solid: " + what); }

SolidElements makeSolidElements(const SolidMesh& mesh) {
  check(mesh);
  const int n = mesh.nodesPerElement;
  const Quadrature quadrature = quadratureOf(n);
  const std::size_t points = quadrature.points.size();
  std::vector<Gradients> reference;
  for (const auto& xi : quadrature.points) reference.push_back(referenceGradients(n, xi));
  SolidElements all;
  all.nodesPerElement = n;
  all.pointsPerElement = static_cast<int>(points);
  all.nodeVolume.assign(mesh.nodes.size(), 0);
  for (int e = 0; e < mesh.elementCount(); ++e) {
    const int* nodes = mesh.elements.data() + std::ptrdiff_t{e} * n;
    const double fill = mesh.fill.empty() ? 1 : mesh.fill[e];
    const double diameter = diameterOf(mesh, nodes);
    std::vector<Eigen::Vector3d> gradients;
    std::vector<double> volumes;
    for (std::size_t q = 0; q < points; ++q) {
      Eigen::Matrix3d jacobian = Eigen::Matrix3d::Zero();  // dX/dxi
      for (int a = 1; a < n; ++a)
        jacobian += (mesh.nodes[nodes[a]] - mesh.nodes[nodes[0]]) * reference[q][a].transpose();
      const double volume = jacobian.determinant() * quadrature.weight;
      if (volume <= kFlattest * diameter * diameter * diameter) break;
      const Eigen::Matrix3d inverse = jacobian.inverse().transpose();
      volumes.push_back(volume);
      for (int a = 0; a < n; ++a) gradients.push_back(inverse * reference[q][a]);
    }
    if (volumes.size() < points) {
      ++all.degenerateCount;
      continue;
    }
    double total = 0;
    for (const double volume : volumes) total += volume;
    for (int a = 0; a < n; ++a) {
      Eigen::Vector3d mean = Eigen::Vector3d::Zero();
      for (std::size_t q = 0; q < points; ++q) {
        mean += volumes[q] / total * gradients[q * static_cast<std::size_t>(n) + static_cast<std::size_t>(a)];
        all.nodeVolume[nodes[a]] += fill * volumes[q] * referenceShape(n, a, quadrature.points[q]);
      }
      all.meanGradient.push_back(mean);
      all.node.push_back(nodes[a]);
    }
    for (const double volume : volumes) all.weight.push_back(fill * volume);
    all.gradient.insert(all.gradient.end(), gradients.begin(), gradients.end());
  }
  if (all.node.empty()) refuseSolid("all elements are degenerate");
  return all;
}

Lame lameOf(const SolidMaterial& material) {
  const auto [rho, E, nu, alpha, beta] = material;
  for (const double x : {rho, E, nu, alpha, beta})
    if (!std::isfinite(x) || x > kLargestConstant)
      refuseSolid("a material constant is not finite, or beyond 1e15");
  if (rho <= 0) refuseSolid("density is not positive");
  if (E <= 0) refuseSolid("Young's modulus is not positive");
  if (nu < 0 || nu >= 0.5) refuseSolid("Poisson's ratio is outside [0, 0.5)");
  if (alpha < 0 || beta < 0) refuseSolid("damping is negative");
  return {E * nu / ((1 + nu) * (1 - 2 * nu)), E / (2 * (1 + nu))};
}

Eigen::Matrix3d stiffnessBlock(const Lame& lame, double w, const Eigen::Vector3d& ga,
                               const Eigen::Vector3d& gb, const Eigen::Vector3d& ma,
                               const Eigen::Vector3d& mb) {
  const double mu = w * lame.mu;
  Eigen::Matrix3d k = (w * lame.lambda + 2. / 3 * mu) * ma * mb.transpose() + mu * gb * ga.transpose() -
                      2. / 3 * mu * ga * gb.transpose();
  k.diagonal().array() += mu * ga.dot(gb);
  return k;
}

}  // namespace pleura
