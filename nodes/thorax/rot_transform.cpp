#include <cmath>
#include <numbers>

#include <pleura/nodes/core/node_type.h>
#include <pleura/nodes/standard/time/time_sensor.h>
#include <pleura/nodes/thorax/motion/rib_motion.h>
#include <pleura/nodes/thorax/rot_transform.h>

namespace pleura {

namespace {

Rotation turned(const Vec3f& angles, double inflation) {
  if (!angles.allFinite() || !std::isfinite(inflation)) return {};
  const RibAngles rib{angles.x(), angles.y(), angles.z()};
  return Rotation(Eigen::Quaternionf(ribRotation(rib, inflation).cast<float>()));
}

/// startTime + elapsedTime: what the sensor's time would be, had it never paused.
Time unpaused(SFTime& time) {
  auto* sensor = dynamic_cast<TimeSensor*>(time.getOwner());
  if (sensor == nullptr || &time != &sensor->time) return time.getValue();
  return sensor->startTime.getValue() + sensor->elapsedTime.getValue();
}

}  // namespace

double sineInflation(SFTime& time, double frequency) {
  return (1 + std::sin(2 * std::numbers::pi * frequency * unpaused(time))) / 2;
}

void RotTransform::declare(NodeType& type) {
  Transform::declare(type);
  type.named("RotTransform", "Pleura").means("a rib: turns about its joint as the chest inflates");
  using enum Access;
  type.field<&RotTransform::angles>("angles", inputOutput, Vec3f::Zero())
      .means("pump-handle and bucket-handle turn at TLC [rad]; side: 1 left, -1 right, 0 midline");
  type.field<&RotTransform::inflation>("inflation", inputOutput, 0)
      .means("0 at FRC, 1 at TLC; moves `rotation`");
  type.field<&RotTransform::rota>("rota", inputOutput, {})
      .means("rotation of a sine of `frequency` over the time routed here; to be routed on to rotation");
  type.field<&RotTransform::frequency>("frequency", inputOutput, 0.25f)
      .measuredIn(Unit::frequency)
      .means("breaths a second, for rota");
  type.field<&RotTransform::points>("points", inputOutput, {})
      .measuredIn(Unit::length)
      .means("points of the rib at rest that others follow");
  type.field<&RotTransform::rib_points>("rib_points", outputOnly, {})
      .measuredIn(Unit::length)
      .means("where `points` are now: P' = M P");
}

void RotTransform::onInitialize() {
  Transform::onInitialize();
  angles.routeNoEvent(turn_);
  inflation.routeNoEvent(turn_);
  turn_.routeNoEvent(rotation);
  points.routeNoEvent(rib_points, id);
  matrix.route(rib_points, id);
}

void RotTransform::Turn::update() {
  value = turned(static_cast<SFVec3f*>(routes_in[0])->getValue(),
                 static_cast<SFFloat*>(routes_in[1])->getValue());
}

void RotTransform::Rota::update() {
  // alpha'(t) = A_pump (1 + sin(2 pi f t)) / 2, beta'(t) = A_bucket (1 + sin(2 pi f t)) / 2
  auto& node = *static_cast<RotTransform*>(getOwner());
  value = turned(node.angles.getValue(),
                 sineInflation(static_cast<SFTime&>(*routes_in[0]), node.frequency.getValue()));
}

void RotTransform::Followed::update() {
  const auto& rest = static_cast<MFVec3f*>(routes_in[0])->getValue();
  const Matrix4f& m = static_cast<SFMatrix4f*>(routes_in[1])->getValue();
  value.resize(rest.size());
  for (std::size_t i = 0; i < rest.size(); ++i)
    value[i] = m.topLeftCorner<3, 3>() * rest[i] + m.topRightCorner<3, 1>();
}

}  // namespace pleura
