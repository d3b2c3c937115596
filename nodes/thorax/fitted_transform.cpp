#include <pleura/nodes/core/node_type.h>
#include <pleura/nodes/thorax/fitted_transform.h>
#include <pleura/nodes/thorax/motion/rigid_fit.h>

namespace pleura {

void FittedTransform::declare(NodeType& type) {
  Transform::declare(type);
  type.named("FittedTransform", "Pleura").means("a rigid body that follows points by least squares");
  using enum Access;
  type.field<&FittedTransform::from>("from", inputOutput, {})
      .measuredIn(Unit::length)
      .means("where the points are at rest");
  type.field<&FittedTransform::to>("to", inputOutput, {})
      .measuredIn(Unit::length)
      .means("where they are now, from any number of routes, in the order of `from`");
}

void FittedTransform::onInitialize() {
  Transform::onInitialize();
  from.routeNoEvent(fit_);
  to.routeNoEvent(fit_);
  fit_.routeNoEvent(rotation_);
  fit_.routeNoEvent(translation_);
  rotation_.routeNoEvent(rotation);
  translation_.routeNoEvent(translation);
}

void FittedTransform::Fit::update() {
  const auto& source = static_cast<MFVec3f*>(routes_in[0])->getValue();
  const auto& target = static_cast<MFVec3f*>(routes_in[1])->getValue();
  value.setIdentity();
  if (source.size() != target.size() || source.empty() || source == target) return;
  from_.clear();
  to_.clear();
  for (const auto& p : source) from_.push_back(p.cast<double>());
  for (const auto& p : target) to_.push_back(p.cast<double>());
  value = fitRigid(from_, to_).matrix();
}

void FittedTransform::FittedRotation::update() {
  const Matrix4d& fit = static_cast<SFMatrix4d*>(routes_in[0])->getValue();
  value = Rotation(Eigen::Quaterniond(fit.topLeftCorner<3, 3>()).cast<float>());
}

void FittedTransform::FittedTranslation::update() {
  value = static_cast<SFMatrix4d*>(routes_in[0])->getValue().topRightCorner<3, 1>().cast<float>();
}

}  // namespace pleura
