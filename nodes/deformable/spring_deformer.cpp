#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <pleura/nodes/core/scene_context.h>
#include <pleura/nodes/deformable/mesh/measures.h>
#include <pleura/nodes/deformable/mesh/precision.h>
#include <pleura/nodes/deformable/spring_deformer.h>

namespace pleura {

void SpringDeformer::declare(NodeType& type) {
  DeformerNode::declare(type);
  type.named("SpringDeformer", "Pleura").means("moves an organ's points by springs along its edges");
  using enum Access;
  type.field<&SpringDeformer::stiffness>("stiffness", inputOutput, 100)
      .positive(1e9)
      .means("of each edge [N/m]; only ratios count for a shape around which there is no pressure");
  type.field<&SpringDeformer::interior>("interior", inputOutput, "EMPTY")
      .means("EMPTY; GAS: p V constant; PRESSURE: a constant difference; VOLUME: held");
  type.field<&SpringDeformer::pressure>("pressure", inputOutput, 0)
      .measuredIn(Unit::pressure)
      .within(-1e9, 1e9)
      .means("inside less outside, from PleuralSpace.transpulmonaryPressure; of a GAS, at rest");
  type.field<&SpringDeformer::restPressure>("restPressure", inputOutput, 0)
      .measuredIn(Unit::pressure)
      .within(-1e9, 1e9)
      .means("a PRESSURE at which the shape is at rest; the load is what is above it");
  type.field<&SpringDeformer::ambientPressure>("ambientPressure", inputOutput, 101325)
      .measuredIn(Unit::pressure)
      .within(0, 1e9)
      .means("outside; counts for GAS");
  type.field<&SpringDeformer::iterations>("iterations", outputOnly, 0).means("of Newton's method");
  type.field<&SpringDeformer::residual>("residual", outputOnly, 0).means("forces out of balance, relative");
  type.field<&SpringDeformer::converged>("converged", outputOnly, true).means("whether the forces balance");
  type.field<&SpringDeformer::interiorPressure>("interiorPressure", outputOnly, 0)
      .measuredIn(Unit::pressure)
      .means("inside less outside, now");
}

std::vector<Field*> SpringDeformer::inputs() {
  return {&stiffness, &interior, &ambientPressure, &pressure, &restPressure};
}

void SpringDeformer::setRest(const TriangleMesh& rest, std::span<const int> /*rigidPoints*/) {
  rest_ = rest;
  makeModel();
}

void SpringDeformer::makeModel() {
  model_.reset();
  SpringInterior inside = EmptyInterior{};
  const std::string& kind = interior.getValue();
  const double outside = ambientPressure.getValue();
  if (kind == "GAS") {
    const double volume = std::abs(signedVolume(rest_.points, rest_.triangles));
    inside = GasInterior{(outside + pressure.getValue()) * volume, outside};
  } else if (kind == "PRESSURE") {
    inside = PressureInterior{};
  } else if (kind == "VOLUME") {
    inside = VolumeInterior{};
  } else if (kind != "EMPTY") {
    throw std::invalid_argument("interior is EMPTY, GAS, PRESSURE or VOLUME, not " + kind);
  }
  model_ = makeSpringModel(rest_.points, rest_.triangles, {.stiffness = {stiffness.getValue()}}, inside);
  workspace_.emplace(*model_);
  positions_.resize(rest_.points.size());
  targets_.reserve(rest_.points.size());
  modelStamp_ = modelStamp();
}

std::uint64_t SpringDeformer::modelStamp() const {
  const std::uint64_t stamp =
      std::max({stiffness.getStamp(), interior.getStamp(), ambientPressure.getStamp()});
  const bool isMadeOfGas = model_ && std::holds_alternative<GasInterior>(model_->interior);
  return isMadeOfGas ? std::max(stamp, pressure.getStamp()) : stamp;
}

void SpringDeformer::prepare(std::span<const int> /*driven*/) {
  if (!model_ || modelStamp() != modelStamp_) makeModel();
  if (auto* inside = std::get_if<PressureInterior>(&model_->interior))
    inside->difference = double{pressure.getValue()} - restPressure.getValue();
}

void SpringDeformer::solve(std::span<const int> driven, std::span<const Vec3f> targets,
                           std::span<Vec3f> positions) {
  requireFinite(targets);
  targets_.resize(targets.size());
  inDouble(targets, targets_);
  report_ = solveSprings(*model_, *workspace_, driven, targets_, {}, positions_);
  if (report_.refused) throw std::invalid_argument("the springs refuse those driven points");
  inFloat(positions_, positions);
  for (std::size_t i = 0; i < driven.size(); ++i) positions[static_cast<std::size_t>(driven[i])] = targets[i];
}

void SpringDeformer::report() {
  iterations.setValue(report_.iterations, id);
  residual.setValue(static_cast<float>(report_.residual), id);
  interiorPressure.setValue(static_cast<float>(report_.pressure), id);
  converged.setValueIfChanged(report_.converged, id);
}

}  // namespace pleura
