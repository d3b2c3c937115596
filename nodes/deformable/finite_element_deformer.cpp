#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

#include <pleura/nodes/core/scene_context.h>
#include <pleura/nodes/deformable/fem/corotational_solid.h>
#include <pleura/nodes/deformable/fem/linear_solid.h>
#include <pleura/nodes/deformable/fem/neo_hookean_solid.h>
#include <pleura/nodes/deformable/fem/pressure.h>
#include <pleura/nodes/deformable/fem/tetrahedra.h>
#include <pleura/nodes/deformable/finite_element_deformer.h>
#include <pleura/nodes/deformable/mesh/measures.h>
#include <pleura/nodes/deformable/mesh/precision.h>

namespace pleura {

namespace {

/// A driven point's spring, of what an element resists with, E h: gives way by less than a hundredth of what
/// the tissue does.
constexpr double kHold = 100;

SoftPoints heldBy(const Embedding& embedding, std::span<const int> driven, double stiffness) {
  SoftPoints soft;
  soft.stiffness = stiffness;
  for (const int point : driven) {
    const auto from = 8 * point;
    soft.node.insert(soft.node.end(), embedding.nodes.begin() + from, embedding.nodes.begin() + from + 8);
    soft.weight.insert(soft.weight.end(), embedding.weights.begin() + from,
                       embedding.weights.begin() + from + 8);
    soft.begin.push_back(static_cast<int>(soft.node.size()));
  }
  return soft;
}

/// The Poisson ratio above which tetrahedra lock: they can't keep their volumes and bend.
constexpr float kLocking = 0.45F;

/// What targets in float are known to [m]: a drive of less is none, and can't be balanced.
constexpr float kTargetRounding = 1e-7f;

std::uint64_t latestStamp(std::span<Field* const> fields) {
  std::uint64_t stamp = 0;
  for (Field* field : fields) stamp = std::max(stamp, field->getStamp());
  return stamp;
}

std::unique_ptr<SolidSolver> solverFor(const std::string& model, const SolidMesh& mesh,
                                       const SolidMaterial& material, const SolidConstraints& held) {
  if (model == "LINEAR") return std::make_unique<LinearSolid>(mesh, material, held);
  // Forces are balanced to a hundred-thousandth of what drives: micrometres of a breath.
  CorotationalOptions options;
  options.tolerance = 1e-5;
  options.iterations = 60;
  if (model == "COROTATIONAL") return std::make_unique<CorotationalSolid>(mesh, material, held, options);
  if (model == "NEO_HOOKEAN") return std::make_unique<NeoHookeanSolid>(mesh, material, held, options);
  throw std::invalid_argument("model is LINEAR, COROTATIONAL or NEO_HOOKEAN, not " + model);
}

}  // namespace

void FiniteElementDeformer::declare(NodeType& type) {
  DeformerNode::declare(type);
  type.named("FiniteElementDeformer", "Pleura").means("moves an organ's points by finite elements inside it");
  using enum Access;
  type.field<&FiniteElementDeformer::model>("model", inputOutput, "COROTATIONAL")
      .means("LINEAR: small rotations; COROTATIONAL: large ones; NEO_HOOKEAN: large strains, the reference");
  type.field<&FiniteElementDeformer::elements>("elements", inputOutput, 2000)
      .within(1, 20000)
      .means("about; memory grows faster than they do, 0.1 GB for 4,000 cubes");
  type.field<&FiniteElementDeformer::elementType>("elementType", inputOutput, "HEXAHEDRON")
      .means("HEXAHEDRON: the lattice's cubes; TETRAHEDRON: each is cut in five, cheaper and stiffer");
  type.field<&FiniteElementDeformer::density>("density", inputOutput, 250)
      .measuredIn(Unit::density)
      .positive(1e5)
      .means("of lung tissue and the air in it");
  type.field<&FiniteElementDeformer::youngsModulus>("youngsModulus", inputOutput, 2000)
      .measuredIn(Unit::pressure)
      .positive(1e12)
      .means("E; a lung of 2 kPa has the compliance that is measured (0.1 L/cmH2O)");
  type.field<&FiniteElementDeformer::poissonRatio>("poissonRatio", inputOutput, 0.3f)
      .within(0, 0.49995)
      .means("nu; near 0.5 the volume stands");
  type.field<&FiniteElementDeformer::massDamping>("massDamping", inputOutput, 0)
      .within(0, 1e6)
      .means("alpha of D = alpha M + beta K [1/s]; counts where quasiStatic is FALSE");
  type.field<&FiniteElementDeformer::stiffnessDamping>("stiffnessDamping", inputOutput, 0.05f)
      .measuredIn(Unit::time)
      .within(0, 1e6)
      .means("beta of D = alpha M + beta K; counts where quasiStatic is FALSE");
  type.field<&FiniteElementDeformer::quasiStatic>("quasiStatic", inputOutput, true)
      .means("whether the shape is that in which all is in balance, or moves with inertia and damping");
  type.field<&FiniteElementDeformer::pressure>("pressure", inputOutput, 0)
      .measuredIn(Unit::pressure)
      .within(-1e9, 1e9)
      .means("inside less outside, from PleuralSpace.transpulmonaryPressure");
  type.field<&FiniteElementDeformer::restPressure>("restPressure", inputOutput, 0)
      .measuredIn(Unit::pressure)
      .within(-1e9, 1e9)
      .means(
          "the pressure at which the shape is at rest; the loads are what is above it, normal to that shape");
  type.field<&FiniteElementDeformer::elementCount>("elementCount", outputOnly, 0).means("elements made");
  type.field<&FiniteElementDeformer::iterations>("iterations", outputOnly, 0)
      .means("linear systems solved, or products with them, for the present shape");
  type.field<&FiniteElementDeformer::residual>("residual", outputOnly, 0)
      .means("forces out of balance over those at the start");
  type.field<&FiniteElementDeformer::converged>("converged", outputOnly, true)
      .means("whether the present shape is the answer; if not, it is the last that was good");
}

std::vector<Field*> FiniteElementDeformer::material() {
  return {&model, &density, &youngsModulus, &poissonRatio, &massDamping, &stiffnessDamping, &quasiStatic};
}

std::vector<Field*> FiniteElementDeformer::inputs() {
  std::vector<Field*> fields = material();
  fields.insert(fields.end(), {&elements, &elementType, &pressure, &restPressure});
  if (!quasiStatic.getValue()) fields.push_back(&context().time);
  return fields;
}

bool FiniteElementDeformer::hasTetrahedra() {
  const std::string& type = elementType.getValue();
  if (type != "HEXAHEDRON" && type != "TETRAHEDRON")
    throw std::invalid_argument("elementType is HEXAHEDRON or TETRAHEDRON, not " + type);
  return type == "TETRAHEDRON";
}

std::uint64_t FiniteElementDeformer::meshStamp() {
  return latestStamp(std::array<Field*, 2>{&elements, &elementType});
}

void FiniteElementDeformer::setRest(const TriangleMesh& rest, std::span<const int> /*rigidPoints*/) {
  rest_ = rest;
  mesh_ = {};
  solver_.reset();
  makeMesh();
}

void FiniteElementDeformer::makeMesh() {
  meshStamp_ = meshStamp();
  const int perCell = hasTetrahedra() ? kTetrahedraPerCell : 1;
  Lattice lattice = makeLattice(rest_, {.elements = std::max(1, elements.getValue() / perCell)});
  embedding_ = embed(lattice, rest_.points);
  cellSize_ = lattice.grid.cellSize;
  mesh_ = perCell == 1 ? std::move(lattice.solid) : cutIntoTetrahedra(lattice);
  points_.resize(rest_.points.size());
  inDouble(rest_.points, points_);
  std::vector<Eigen::Vector3d> onPoints(rest_.points.size(), Eigen::Vector3d::Zero());
  addPressureForces(1, points_, rest_.triangles, onPoints);
  pull_.assign(mesh_.nodes.size(), Eigen::Vector3d::Zero());
  addTransposed(embedding_, onPoints, pull_);
  forces_ = pull_;
  solver_.reset();
  elementCount.setValue(mesh_.elementCount(), id);
  for (const std::string& finding : findings(lattice.report)) context().warn(*this, finding);
}

void FiniteElementDeformer::makeSolver(std::span<const int> driven) {
  solver_.reset();
  driven_.assign(driven.begin(), driven.end());
  const SolidMaterial material{.density = density.getValue(),
                               .youngsModulus = youngsModulus.getValue(),
                               .poissonRatio = poissonRatio.getValue(),
                               .massDamping = massDamping.getValue(),
                               .stiffnessDamping = stiffnessDamping.getValue()};
  const double hold = kHold * material.youngsModulus * cellSize_;
  solver_ =
      solverFor(model.getValue(), mesh_, material, {.fixed = {}, .soft = heldBy(embedding_, driven, hold)});
  if (hasTetrahedra() && poissonRatio.getValue() > kLocking)
    context().warn(*this,
                   "tetrahedra of a poissonRatio above 0.45 are stiffer than the tissue; HEXAHEDRON is not");
  atRest_ = solver_->state();
  time_ = context().time.getValue();
  targets_.resize(driven.size());
}

bool FiniteElementDeformer::isAtRest(std::span<const Vec3f> targets) const {
  for (std::size_t i = 0; i < targets.size(); ++i)
    if ((targets[i] - rest_.points[static_cast<std::size_t>(driven_[i])]).norm() > kTargetRounding)
      return false;
  return true;
}

void FiniteElementDeformer::prepare(std::span<const int> driven) {
  if (driven.empty()) return;
  const std::uint64_t stamp = latestStamp(material());
  if (meshStamp() != meshStamp_) makeMesh();
  if (!solver_ || stamp != solverStamp_ ||
      !std::equal(driven.begin(), driven.end(), driven_.begin(), driven_.end()))
    makeSolver(driven);
  solverStamp_ = stamp;
  pressure_ = double{pressure.getValue()} - restPressure.getValue();
  step_ = std::numeric_limits<double>::infinity();
  if (quasiStatic.getValue()) return;
  asked_ = context().time.getValue();
  step_ = std::max(0.0, asked_ - time_);
}

SolidReport FiniteElementDeformer::move(std::span<const Vec3f> targets) {
  if (step_ == 0) return report_;
  const bool isStatic = std::isinf(step_);
  if (isStatic) solver_->setState(atRest_);
  if (isStatic && pressure_ == 0 && isAtRest(targets)) return {};
  inDouble(targets, targets_);
  std::transform(pull_.begin(), pull_.end(), forces_.begin(),
                 [this](const Eigen::Vector3d& f) { return Eigen::Vector3d(pressure_ * f); });
  if (!isStatic) time_ = asked_;
  return solver_->step(step_, {.forces = forces_, .targets = targets_});
}

void FiniteElementDeformer::report() {
  iterations.setValue(report_.iterations, id);
  residual.setValue(static_cast<float>(report_.residual), id);
  converged.setValueIfChanged(report_.converged(), id);
  if (report_.outcome == SolidOutcome::stopped)
    context().warn(*this, "the forces of a shape were not balanced in the iterations there are");
  else if (!report_.converged())
    context().warn(*this, "a shape was not found: it is the last that was good");
}

void FiniteElementDeformer::solve(std::span<const int> driven, std::span<const Vec3f> targets,
                                  std::span<Vec3f> positions) {
  requireFinite(targets);
  if (driven.empty()) {
    report_ = {};
    return void(std::copy(rest_.points.begin(), rest_.points.end(), positions.begin()));
  }
  report_ = move(targets);
  interpolate(embedding_, solver_->state().position, points_);
  inFloat(points_, positions);
  for (std::size_t i = 0; i < driven.size(); ++i) positions[static_cast<std::size_t>(driven[i])] = targets[i];
}

}  // namespace pleura
