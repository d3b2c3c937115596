#include <pleura/x3d/browser/touch/device_outputs.h>

namespace pleura {

namespace {

constexpr unsigned kMainButton = 1;
constexpr unsigned kSecondaryButton = 2;

Vec3f toFloat(const Eigen::Vector3d& v) { return v.cast<float>(); }

Rotation toRotation(const Eigen::Quaterniond& q) { return Rotation(Eigen::Quaternionf(q.cast<float>())); }

}  // namespace

void setOutputs(HapticsDeviceNode& node, const haptics::ServoReport& report, const TouchedPart& touched) {
  const auto set = [&node](auto& field, const auto& value) { field.setValueIfChanged(value, node.id); };
  set(node.isConnected, report.isConnected);
  set(node.devicePosition, toFloat(report.device.position));
  set(node.deviceOrientation, toRotation(report.device.orientation));
  set(node.deviceVelocity, toFloat(report.device.velocity));
  const Eigen::Vector3d& tracker = report.trackerPosition;
  const Eigen::Vector3d& proxy = report.proxyPosition;
  set(node.trackerPosition, toFloat(tracker));
  const auto calibration = node.orientationCalibration.getValue().quaternion();
  set(node.trackerOrientation, toRotation(calibration.cast<double>() * report.trackerOrientation));
  set(node.trackerVelocity, toFloat(report.trackerVelocity));
  set(node.proxyPosition, toFloat(proxy));
  const double weight = node.proxyWeighting.getValue();
  set(node.weightedProxyPosition, toFloat(weight * proxy + (1 - weight) * tracker));
  set(node.tipPosition, toFloat(proxy + touched.givenWay));
  set(node.mainButton, (report.device.buttons & kMainButton) != 0);
  set(node.secondaryButton, (report.device.buttons & kSecondaryButton) != 0);
  set(node.buttons, static_cast<int>(report.device.buttons));
  set(node.force, toFloat(report.force));
  set(node.torque, toFloat(report.torque));
  const double newtons = report.force.norm();
  if (newtons > 0)
    set(node.forceRotation,
        toRotation(Eigen::Quaterniond::FromTwoVectors(Eigen::Vector3d::UnitY(), report.force)));
  set(node.forceScale, Vec3f(1, static_cast<float>(newtons), 1));
  set(node.depth, report.contactCount > 0 ? static_cast<float>((proxy - tracker).norm()) : 0.0f);
  const auto& [name, title] = touched.called;
  set(node.touched, name);
  if (node.label.empty() ? !title.empty() : node.label.getValue().front() != title)
    node.label.setValue(title.empty() ? std::vector<std::string>() : std::vector{title}, node.id);
}

void setOutputs(const TouchScene::Part& part, const haptics::ServoReport::Contact* contact,
                const Eigen::Vector3d& force, std::size_t device, std::size_t devices) {
  X3DGeometryNode& node = *part.geometry;
  const auto set = [&](auto& field, const auto& value) {
    field.edit(
        [&](auto& values) {
          values.resize(devices);
          values[device] = value;
        },
        node.id);
  };
  set(node.isTouched, contact != nullptr);
  if (contact == nullptr) {
    set(node.force, Vec3f(Vec3f::Zero()));
    return set(node.contactDepth, 0.0f);
  }
  const Eigen::Affine3d toWorld(part.toWorld.cast<double>());
  const Eigen::Vector3d normal = (toWorld.linear().transpose() * contact->normal).normalized();
  const double stretch = (toWorld.linear() * normal).norm();
  set(node.force, toFloat(toWorld.rotation().transpose() * force));
  set(node.contactPoint, toFloat(toWorld.inverse() * contact->point));
  set(node.contactNormal, toFloat(normal));
  set(node.contactDepth, static_cast<float>(contact->depth / stretch));
}

}  // namespace pleura
