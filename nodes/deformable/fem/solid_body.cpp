#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include <pleura/nodes/deformable/fem/solid_body.h>

namespace pleura {
namespace {

void check(const SolidConstraints& constraints, int nodeCount) {
  std::vector<bool> isFixed(nodeCount, false);
  for (const int i : constraints.fixed) {
    if (i < 0 || i >= nodeCount) refuseSolid("fixed node " + std::to_string(i) + " is not in the mesh");
    if (isFixed[i]) refuseSolid("node " + std::to_string(i) + " is fixed twice");
    isFixed[i] = true;
  }
  const SoftPoints& soft = constraints.soft;
  if (!std::isfinite(soft.stiffness) || soft.stiffness < 0)
    refuseSolid("the soft points' stiffness is not 0 or more");
  if (soft.begin.empty() || soft.begin.front() != 0 ||
      soft.begin.back() != static_cast<int>(soft.node.size()) || soft.node.size() != soft.weight.size())
    refuseSolid("the soft points' rows do not fit");
  for (std::size_t r = 0; r + 1 < soft.begin.size(); ++r)
    if (soft.begin[r] > soft.begin[r + 1]) refuseSolid("the soft points' rows do not fit");
  for (const int i : soft.node)
    if (i < 0 || i >= nodeCount) refuseSolid("soft node " + std::to_string(i) + " is not in the mesh");
  for (int r = 0; r < soft.count(); ++r) {
    std::vector<int> row(soft.node.begin() + soft.begin[r], soft.node.begin() + soft.begin[r + 1]);
    std::sort(row.begin(), row.end());
    if (std::adjacent_find(row.begin(), row.end()) != row.end())
      refuseSolid("a soft point names a node twice");
  }
  for (const double weight : soft.weight)
    if (!std::isfinite(weight)) refuseSolid("a soft weight is not finite");
}

bool areUsable(std::span<const Eigen::Vector3d> vectors) {
  for (const auto& vector : vectors)
    for (const double x : vector)
      if (!std::isfinite(x) || std::abs(x) > kFarthestNode) return false;
  return true;
}

Eigen::Vector3d softPoint(const SoftPoints& soft, int r, const NodeVectors& x) {
  Eigen::Vector3d point = Eigen::Vector3d::Zero();
  for (int k = soft.begin[r]; k < soft.begin[r + 1]; ++k) point += soft.weight[k] * x[soft.node[k]];
  return point;
}

// Appends the slots of the pairs (a, b >= a) of each group.
std::vector<int> pairSlots(const BlockPattern& pattern, std::span<const int> begin,
                           std::span<const int> node) {
  std::vector<int> slots;
  for (std::size_t g = 0; g + 1 < begin.size(); ++g)
    for (int a = begin[g]; a < begin[g + 1]; ++a)
      for (int b = a; b < begin[g + 1]; ++b) slots.push_back(pattern.slot(node[a], node[b]));
  return slots;
}

std::vector<SolidBody::Coupling> couplingsOf(const SolidBody& body) {
  std::vector<SolidBody::Coupling> couplings;
  for (int i = 0; i < body.pattern.rowCount(); ++i)
    for (int slot = body.pattern.begin[i]; slot < body.pattern.begin[i + 1]; ++slot) {
      const int j = body.pattern.column[slot];
      if (body.isUnknown[i] && !body.isUnknown[j]) couplings.push_back({slot, i, j});
      if (!body.isUnknown[i] && body.isUnknown[j]) couplings.push_back({~slot, j, i});
    }
  return couplings;
}

}  // namespace

SolidBody makeSolidBody(const SolidMesh& mesh, const SolidMaterial& material,
                        const SolidConstraints& constraints) {
  SolidBody body{};
  body.lame = lameOf(material);
  body.elements = makeSolidElements(mesh);
  check(constraints, static_cast<int>(mesh.nodes.size()));
  body.massDamping = material.massDamping;
  body.stiffnessDamping = material.stiffnessDamping;
  body.rest = mesh.nodes;
  body.constraints = constraints;
  const SoftPoints& soft = constraints.soft;
  for (int r = 0; r < soft.count(); ++r) body.restTargets.push_back(softPoint(soft, r, body.rest));
  body.isUnknown.assign(mesh.nodes.size(), false);
  for (const int i : body.elements.node) body.isUnknown[i] = true;
  for (const int i : constraints.fixed) body.isUnknown[i] = false;
  for (std::size_t i = 0; i < mesh.nodes.size(); ++i) {
    body.mass.push_back(material.density * body.elements.nodeVolume[i]);
    if (body.isUnknown[i]) body.unknowns.push_back(static_cast<int>(i));
  }
  std::vector<int> begin, node = body.elements.node;
  for (int e = 0; e <= body.elements.count(); ++e) begin.push_back(e * body.elements.nodesPerElement);
  const std::vector<int> elementBegin = begin;
  const int elementNodes = static_cast<int>(node.size());
  node.insert(node.end(), soft.node.begin(), soft.node.end());
  for (int r = 1; r <= soft.count(); ++r) begin.push_back(elementNodes + soft.begin[r]);
  body.pattern = makeBlockPattern(static_cast<int>(mesh.nodes.size()), begin, node);
  body.elementSlots = pairSlots(body.pattern, elementBegin, body.elements.node);
  body.softSlots = pairSlots(body.pattern, soft.begin, soft.node);
  body.couplings = couplingsOf(body);
  return body;
}

bool isUsable(const SolidBody& body, const SolidState& state) {
  return state.position.size() == body.rest.size() && state.velocity.size() == body.rest.size() &&
         areUsable(state.position) && areUsable(state.velocity);
}

bool isUsable(const SolidBody& body, const SolidLoad& load) {
  const auto fits = [](std::span<const Eigen::Vector3d> vectors, std::size_t count) {
    return (vectors.empty() || vectors.size() == count) && areUsable(vectors);
  };
  return fits(load.forces, body.rest.size()) && fits(load.prescribed, body.constraints.fixed.size()) &&
         fits(load.targets, body.restTargets.size());
}

bool isUsableStep(double h) { return !std::isnan(h) && h >= 1e-9 && (h <= 1e9 || std::isinf(h)); }

void addInertia(const SolidBody& body, double rate, BlockValues& A) {
  for (std::size_t i = 0; i < body.mass.size(); ++i)
    A[body.pattern.begin[i]].diagonal().array() += (rate + body.massDamping) * rate * body.mass[i];
}

void addSoftStiffness(const SolidBody& body, BlockValues& values) {
  const SoftPoints& soft = body.constraints.soft;
  auto slot = body.softSlots.begin();
  for (std::size_t r = 0; r + 1 < soft.begin.size(); ++r)
    for (int a = soft.begin[r]; a < soft.begin[r + 1]; ++a)
      for (int b = a; b < soft.begin[r + 1]; ++b)
        addBlock(values, *slot++,
                 soft.stiffness * soft.weight[a] * soft.weight[b] * Eigen::Matrix3d::Identity());
}

void addSoftForces(const SolidBody& body, const SolidLoad& load, const NodeVectors& x, NodeVectors& forces) {
  const SoftPoints& soft = body.constraints.soft;
  for (int r = 0; r < soft.count(); ++r) {
    const Eigen::Vector3d& target = load.targets.empty() ? body.restTargets[r] : load.targets[r];
    const Eigen::Vector3d pull = soft.stiffness * (target - softPoint(soft, r, x));
    for (int k = soft.begin[r]; k < soft.begin[r + 1]; ++k) forces[soft.node[k]] += soft.weight[k] * pull;
  }
}

double softEnergy(const SolidBody& body, const SolidLoad& load, const NodeVectors& x) {
  const SoftPoints& soft = body.constraints.soft;
  double sum = 0;
  for (int r = 0; r < soft.count(); ++r) {
    const Eigen::Vector3d& target = load.targets.empty() ? body.restTargets[r] : load.targets[r];
    sum += (target - softPoint(soft, r, x)).squaredNorm();
  }
  return 0.5 * soft.stiffness * sum;
}

void subtractFixed(const SolidBody& body, const BlockValues& A, const NodeVectors& d, NodeVectors& b) {
  for (const auto& [slot, unknown, fixed] : body.couplings) {
    if (slot >= 0)
      b[unknown] -= A[slot] * d[fixed];
    else
      b[unknown] -= A[~slot].transpose() * d[fixed];
  }
}

void prescribe(const SolidBody& body, const SolidLoad& load, const NodeVectors& position, NodeVectors& d) {
  std::fill(d.begin(), d.end(), Eigen::Vector3d::Zero());
  for (std::size_t k = 0; k < load.prescribed.size(); ++k) {
    const int i = body.constraints.fixed[k];
    d[i] = load.prescribed[k] - position[i];
  }
}

double freeNorm(const SolidBody& body, const NodeVectors& x) {
  double sum = 0;
  for (const int i : body.unknowns) sum += x[i].squaredNorm();
  return std::sqrt(sum);
}

}  // namespace pleura
