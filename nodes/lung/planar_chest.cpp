#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <pleura/nodes/core/scene_context.h>
#include <pleura/nodes/lung/planar_chest.h>
#include <pleura/nodes/lung/time_steps.h>

namespace pleura {

namespace {

Vec3f inOne(const planar::ChestCoordinate& c) {
  return Eigen::Vector3d(c.mass, c.damping, c.stiffness).cast<float>();
}

planar::ChestCoordinate inThree(const Vec3f& c) { return {c[0], c[1], c[2]}; }

}  // namespace

void PlanarChest::declare(NodeType& type) {
  Node::declare(type);
  type.named("PlanarChest", "Pleura")
      .means("lungs that breathe in a chest, in a coronal section (DeCarlo et al. 1995)");
  using enum Access;
  const PlanarLungParameters byDefault;
  type.field<&PlanarChest::lungs>("lungs", initializeOnly, {}).means("the PlanarLungs in it");
  type.field<&PlanarChest::diaphragm>("diaphragm", initializeOnly, inOne(byDefault.diaphragm))
      .atLeast(0)
      .means("mass [kg], damping [N s/m] and stiffness [N/m]; chosen, not measured");
  type.field<&PlanarChest::chestWall>("chestWall", initializeOnly, inOne(byDefault.chestWall))
      .atLeast(0)
      .means("mass [kg], damping [N s/m] and stiffness [N/m]; chosen, not measured");
  type.field<&PlanarChest::thickness>("thickness", initializeOnly, static_cast<float>(byDefault.thickness))
      .measuredIn(Unit::length)
      .positive(10)
      .means("of the section, from front to back");
  type.field<&PlanarChest::intrapleuralPressure>("intrapleuralPressure", initializeOnly,
                                                 static_cast<float>(byDefault.intrapleuralPressure))
      .measuredIn(Unit::pressure)
      .within(-5000, 0)
      .means("above ambient, at the start of the breath; -5 cmH2O (Guyton)");
  type.field<&PlanarChest::ambientPressure>("ambientPressure", initializeOnly,
                                            static_cast<float>(byDefault.ambientPressure))
      .measuredIn(Unit::pressure)
      .within(1e3, 1e7)
      .means("of the air outside and in the lungs");
  type.field<&PlanarChest::muscleForce>("muscleForce", initializeOnly, Vec2f(10, 6))
      .measuredIn(Unit::force)
      .within(0, 1000)
      .means("of full effort: on the diaphragm, down, and on the chest wall, out");
  type.field<&PlanarChest::effort>("effort", inputOutput, 0)
      .within(0, 1)
      .means("of the breathing muscles; 0 is an exhale, from Respiration.inflation");
  type.field<&PlanarChest::diaphragmDescent>("diaphragmDescent", outputOnly, 0)
      .measuredIn(Unit::length)
      .means("of the middle of its dome, from its own rest");
  type.field<&PlanarChest::wallExcursion>("wallExcursion", outputOnly, 0)
      .measuredIn(Unit::length)
      .means("of the lower lateral wall, out from its own rest");
}

void PlanarChest::onInitialize() {
  for (const NodePtr& node : lungs.getValue(id))
    if (auto* lung = dynamic_cast<PlanarLung*>(node.get())) members_.push_back(lung);
  try {
    begin();
  } catch (const std::invalid_argument& refused) {
    return context().warn(*this, refused.what());
  }
  time_ = context().time.getValue();
  context().time.routeNoEvent(diaphragmDescent, id);
  context().time.routeNoEvent(wallExcursion, id);
  for (std::size_t k = 0; k < members_.size(); ++k) members_[k]->join(*this, k);
}

void PlanarChest::begin() {
  PlanarLungParameters parameters;
  parameters.lungs.clear();
  for (PlanarLung* lung : members_) parameters.lungs.push_back(lung->parameters());
  parameters.diaphragm = inThree(diaphragm.getValue(id));
  parameters.chestWall = inThree(chestWall.getValue(id));
  parameters.thickness = thickness.getValue(id);
  parameters.intrapleuralPressure = intrapleuralPressure.getValue(id);
  parameters.ambientPressure = ambientPressure.getValue(id);
  PlanarLungSystem made(parameters);
  if (!made.drawOut().isConverged)
    throw std::invalid_argument("the lungs can't be drawn out to the wall by that intrapleuralPressure");
  for (std::size_t k = 0; k < members_.size(); ++k) pleuralVolume_.push_back(made.pleuralVolume(k));
  system_.emplace(std::move(made));
}

/// A closed wound's air is drawn out at the pressure of the start, until hardly more is left than there was.
void PlanarChest::tendWounds() {
  constexpr double kDrawnOut = 1.05;
  for (std::size_t k = 0; k < members_.size(); ++k) {
    if (members_[k]->pneumothorax.getValue()) {
      system_->setPressure(k, 0);
    } else if (!system_->isSealed(k)) {
      system_->setPressure(k, intrapleuralPressure.getValue(id));
      if (system_->pleuralVolume(k) < kDrawnOut * pleuralVolume_[k]) system_->seal(k);
    }
  }
}

void PlanarChest::advanceTo(Time time) {
  tendWounds();
  const float effortNow = effort.getValue();
  const TimeSteps steps = timeSteps(time - time_);
  const Eigen::Vector2d most = muscleForce.getValue(id).cast<double>();
  for (int k = 1; k <= steps.count; ++k) {
    const double part = static_cast<double>(k) / steps.count;
    const Eigen::Vector2d muscles = (effort_ + part * (effortNow - effort_)) * most;
    if (!system_->step(steps.length, muscles).isConverged)
      context().warn(*this, "a step did not converge: the chest stands still meanwhile");
  }
  effort_ = effortNow;
}

PlanarLungSystem* PlanarChest::now() {
  if (!system_) return nullptr;
  const Time time = context().time.getValue();
  if (time > time_) advanceTo(time);
  time_ = time;
  return &*system_;
}

}  // namespace pleura
